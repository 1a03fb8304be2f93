# How each kind of file is made.  A study lists its products with what they are made from; the recipe follows from the kind.
# An input is found among the prerequisites by its ending; a prerequisite that is a program makes the product follow the program.
BIN = $(BUILD)/bin

# A failed tool must leave no product that looks done: .DELETE_ON_ERROR stands in the Makefile, and -o renames when complete.
of = $(filter %$1,$^)

out/%-l.prof: $(BIN)/vxprofile
	@mkdir -p $(@D)
	$(BIN)/vxprofile --side l $(SET) -o $@ $(firstword $(call of,.yaml))

out/%-r.prof: $(BIN)/vxprofile
	@mkdir -p $(@D)
	$(BIN)/vxprofile --side r $(SET) -o $@ $(firstword $(call of,.yaml))

# First the wheel, then the rail.
YAW = exact
out/%.ctab: $(BIN)/vxcontact
	$(BIN)/vxcontact --wheel $(word 1,$(call of,.prof)) --rail $(word 2,$(call of,.prof)) --yaw $(YAW) -o $@

out/%.creep: $(BIN)/vxcreep
	@mkdir -p $(@D)
	$(BIN)/vxcreep --table $(CREEP) -o $@

out/%.trk: $(BIN)/vxtrack
	@mkdir -p $(@D)
	$(BIN)/vxtrack $(SET) -o $@ $(call of,.yaml)

out/%.veh: $(BIN)/vxvehicle
	@mkdir -p $(@D)
	$(BIN)/vxvehicle $(SET) -o $@ $(call of,.yaml)

out/%.frf: $(BIN)/vxfreq
	$(BIN)/vxfreq --receptance $(RECEPTANCE) -o $@ $(call of,.trk)

out/%.mod: $(BIN)/vxfreq
	$(BIN)/vxfreq --modes $(MODES) -o $@ $(call of,.trk) $(call of,.veh)

out/%.run: $(BIN)/vxrun
	$(BIN)/vxrun $(SET) --track $(call of,.trk) --vehicle $(call of,.veh) --contact-left $(call of,-l.ctab) \
	    --contact-right $(call of,-r.ctab) $(addprefix --creep ,$(call of,.creep)) -o $@ $(call of,.yaml)

out/%.csv: $(BIN)/vxpost
	$(BIN)/vxpost $(POST) -o $@ $(call of,.run)

# What vxcontact says of tables; of a wheelset, first the left one.
out/%.txt: $(BIN)/vxcontact
	$(BIN)/vxcontact $(ASK) $(call of,.ctab) >$@

out/%.png: $(BIN)/vxplot
	$(BIN)/vxplot $(PLOT) -o $@ $(filter-out $(BIN)/%,$^)
