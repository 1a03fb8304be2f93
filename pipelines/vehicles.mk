# Question: is each shipped vehicle what its input says, and how does it move by itself?
# Figures: each vehicle in three views, and its first twelve modes with the wheelsets held (figure 2 b of Lau and Hoff 2018), with what
# vxvehicle --check says of it.  Time: about 5 s on one core, most of it pictures.
# Headline: bounce of the Manchester coach 1.074 Hz (out/vehicles/manchester-passenger-modes.txt).
V = out/vehicles
VEHICLES = $(basename $(notdir $(wildcard data/vehicles/*.yaml)))
MOVING = $(filter-out wheelset quarter-car,$(VEHICLES))

vehicles: $(VEHICLES:%=$V/%.png) $(VEHICLES:%=$V/%-check.txt) $(MOVING:%=$V/%-modes.png) $(MOVING:%=$V/%-modes.txt)  ## drawings and modes of the vehicles, into out/vehicles
.PHONY: vehicles

$(VEHICLES:%=$V/%.veh): $V/%.veh: data/vehicles/%.yaml
$(VEHICLES:%=$V/%.png): $V/%.png: $V/%.veh
$(VEHICLES:%=$V/%.png): PLOT = --figure vehicle
$(MOVING:%=$V/%.mod): $V/%.mod: $V/%.veh
$(MOVING:%=$V/%.mod): MODES = 12
$(MOVING:%=$V/%-modes.png): $V/%-modes.png: $V/%.mod $V/%.veh
$(MOVING:%=$V/%-modes.png): PLOT = --figure modes

$(VEHICLES:%=$V/%-check.txt): $V/%-check.txt: data/vehicles/%.yaml $(BIN)/vxvehicle
	@mkdir -p $(@D)
	$(BIN)/vxvehicle --check $< >$@
$(MOVING:%=$V/%-modes.txt): $V/%-modes.txt: $V/%.veh $(BIN)/vxfreq
	$(BIN)/vxfreq --modes 12 --text $< >$@
