# Question: is each shipped vehicle what its input says, and how does it move by itself?
# Figures: each vehicle in three views, and its first twelve modes with the wheelsets held (figure 2 b of Lau and Hoff 2018), with what
# vxvehicle --check says of it.  Time: about 5 s on one core, most of it pictures.
# Headline: bounce of the Manchester coach 1.074 Hz (out/vehicles/manchester-passenger-modes.txt).
FLEET = out/vehicles
VEHICLES = $(basename $(notdir $(wildcard data/vehicles/*.yaml)))
MOVING = $(filter-out wheelset quarter-car,$(VEHICLES))

vehicles: $(VEHICLES:%=$(FLEET)/%.png) $(VEHICLES:%=$(FLEET)/%-check.txt) $(MOVING:%=$(FLEET)/%-modes.png) $(MOVING:%=$(FLEET)/%-modes.txt)  ## drawings and modes of the vehicles, into out/vehicles
.PHONY: vehicles

$(VEHICLES:%=$(FLEET)/%.veh): $(FLEET)/%.veh: data/vehicles/%.yaml
$(VEHICLES:%=$(FLEET)/%.png): $(FLEET)/%.png: $(FLEET)/%.veh
$(VEHICLES:%=$(FLEET)/%.png): PLOT = --figure vehicle
$(MOVING:%=$(FLEET)/%.mod): $(FLEET)/%.mod: $(FLEET)/%.veh
$(MOVING:%=$(FLEET)/%.mod): MODES = 12
$(MOVING:%=$(FLEET)/%-modes.png): $(FLEET)/%-modes.png: $(FLEET)/%.mod $(FLEET)/%.veh
$(MOVING:%=$(FLEET)/%-modes.png): PLOT = --figure modes

$(VEHICLES:%=$(FLEET)/%-check.txt): $(FLEET)/%-check.txt: data/vehicles/%.yaml $(BIN)/vxvehicle
	@mkdir -p $(@D)
	$(BIN)/vxvehicle --check $< >$@
$(MOVING:%=$(FLEET)/%-modes.txt): $(FLEET)/%-modes.txt: $(FLEET)/%.veh $(BIN)/vxfreq
	$(BIN)/vxfreq --modes 12 --text $< >$@
