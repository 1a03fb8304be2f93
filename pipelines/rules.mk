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
	@mkdir -p $(@D)
	$(BIN)/vxrun $(SET) --track $(call of,.trk) --vehicle $(call of,.veh) --contact-left $(call of,-l.ctab) \
	    --contact-right $(call of,-r.ctab) $(addprefix --creep ,$(call of,.creep)) -o $@ $(call of,.yaml)

out/%.csv: $(BIN)/vxpost
	$(BIN)/vxpost $(POST) -o $@ $(call of,.run)

# Samples of every wheelset, and how passages differ from the last one; that needs the run of one of them to tell which body is a wheelset.
SAMPLES = station body.q contact.wheel_y contact.rail_y wheel.Q wheel.Y
out/%-samples.csv: out/%.run $(BIN)/vxdump
	$(BIN)/vxdump --csv -o $@ $< $(SAMPLES)

out/%-differences.csv: pipelines/passages.awk $(BIN)/vxdump
	awk -v between="$(BETWEEN)" -v bodies="$$($(BIN)/vxdump --csv $(call of,.run) wheelset.body | sed 1d)" 	    -v x="$$($(BIN)/vxdump --csv $(call of,.run) wheelset.x | sed 1d)" -f $< $(call of,-samples.csv) >$@

# What vxcontact says of tables; of a wheelset, first the left one.
out/%.txt: $(BIN)/vxcontact
	$(BIN)/vxcontact $(ASK) $(call of,.ctab) >$@

out/%.png: $(BIN)/vxplot
	$(BIN)/vxplot $(PLOT) -o $@ $(filter-out $(BIN)/%,$^)
