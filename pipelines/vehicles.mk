# Question: is each shipped vehicle what its input says, and how does it move by itself?
# Figures: each vehicle in three views, and its first twelve modes with the wheelsets held (figure 2 b of Lau and Hoff 2018), with what
# vxvehicle --check says of it.  Time: about 5 s on one core, most of it pictures.
# Headline: bounce of the Manchester coach 1.074 Hz (out/vehicles/manchester-passenger-modes.txt).
FLEET = out/vehicles
VEHICLES = $(basename $(notdir $(wildcard data/vehicles/*.yaml)))

vehicles: $(VEHICLES:%=$(FLEET)/%.png) $(VEHICLES:%=$(FLEET)/%-check.txt) $(VEHICLES:%=$(FLEET)/%-modes.png) $(VEHICLES:%=$(FLEET)/%-modes.txt)  ## drawings and modes of the vehicles, into out/vehicles
.PHONY: vehicles

$(VEHICLES:%=$(FLEET)/%.veh): $(FLEET)/%.veh: data/vehicles/%.yaml
$(VEHICLES:%=$(FLEET)/%.png): $(FLEET)/%.png: $(FLEET)/%.veh
$(VEHICLES:%=$(FLEET)/%.png): PLOT = --figure vehicle
$(VEHICLES:%=$(FLEET)/%.mod): $(FLEET)/%.mod: $(FLEET)/%.veh
$(VEHICLES:%=$(FLEET)/%.mod) $(VEHICLES:%=$(FLEET)/%-modes.txt): MODES = 12
# Of its one body beside the wheelset:
$(FLEET)/wheelset.mod $(FLEET)/wheelset-modes.txt: MODES = 6
$(VEHICLES:%=$(FLEET)/%-modes.png): $(FLEET)/%-modes.png: $(FLEET)/%.mod $(FLEET)/%.veh
$(VEHICLES:%=$(FLEET)/%-modes.png): PLOT = --figure modes

$(VEHICLES:%=$(FLEET)/%-check.txt): $(FLEET)/%-check.txt: data/vehicles/%.yaml $(BIN)/vxvehicle
	@mkdir -p $(@D)
	$(BIN)/vxvehicle --check $< >$@
$(VEHICLES:%=$(FLEET)/%-modes.txt): $(FLEET)/%-modes.txt: $(FLEET)/%.veh $(BIN)/vxfreq
	$(BIN)/vxfreq --modes $(MODES) --text $< >$@
