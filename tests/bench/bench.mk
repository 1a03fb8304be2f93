# Times and memory against the budgets; never part of check.
BENCHES = $(patsubst tests/bench/%.c,$(BUILD)/tests/bench/%,$(wildcard tests/bench/*.c))

$(BUILD)/tests/bench/%: $(BUILD)/tests/bench/%.o $(BUILD)/libvx.a
	@echo "ld $@"
	$(Q)$(CC) $(ALL_LDFLAGS) -o $@ $^ $(LIBS)

bench: $(PROGRAMS) $(BENCHES) ## times and memory against their budgets, out/bench.tsv
	@mkdir -p out
	@bash tests/bench/bench.sh out/bench.tsv
