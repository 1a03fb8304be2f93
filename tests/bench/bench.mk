# Times and memory against the budgets; never part of check.
bench: $(PROGRAMS)          ## times and memory against their budgets, out/bench.tsv
	@mkdir -p out
	@bash tests/bench/bench.sh out/bench.tsv
