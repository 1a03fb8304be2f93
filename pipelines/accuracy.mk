# Question: what do the fast settings (step 1e-4 s, FASTSIM 10x10) cost in accuracy, against a step of 1e-5 s and FASTSIM 50x50 on the same track?
# Figure: none; tables of every largest wheel force, pad force and pad compression by zone, two trains on two routes on three ballasts.
# Time: about seven minutes on one core, so it is no part of make check.
# Headline: coach within 1.4 per cent, freight wagon, which hunts at 120 km/h, within 5.6; with FASTSIM 50x50 alone 1.4 (out/accuracy/summary.txt).
A = out/accuracy

# A run is TRAIN-ROUTE-BALLAST, ballast in MN/m of a sleeper.  Settings fast, reference, and grid, the fast step with the reference's FASTSIM, are
# of one track; mesh is another model, four elements a bay with consistent mass, and the implicit scheme.
TRAINS = passenger freight
ROUTES = through diverging
BALLASTS = 50 400 3000
TWELVE = $(foreach t,$(TRAINS),$(foreach r,$(ROUTES),$(foreach b,$(BALLASTS),$t-$r-$b)))

accuracy: $A/summary.txt $A/comparison.csv $A/grid.csv $A/model.csv  ## fast against reference settings, twelve passages, into out/accuracy: minutes
.PHONY: accuracy

$A/wheel-l.prof $A/wheel-r.prof: data/profiles/S1002.yaml
$A/diverging-l.prof $A/diverging-r.prof $A/through-l.prof $A/through-r.prof: data/turnouts/60E1-R760-1-15.yaml data/profiles/60E1.yaml
$A/through-l.prof $A/through-r.prof: SET = --set turnout.route=through
$(foreach r,$(ROUTES),$(foreach s,l r,$(eval $A/$r-$s.ctab: $A/wheel-$s.prof $A/$r-$s.prof)))
$A/passenger.veh: data/vehicles/passenger-19t.yaml
$A/freight.veh: data/vehicles/freight-y25-22t5.yaml

define track
$A/$1-$2.trk $A/$1-mesh-$2.trk: data/tracks/60E1-R760-1-15-$1.yaml
$A/$1-$2.trk: SET = --set ballast.stiffness=$2e6
$A/$1-mesh-$2.trk: SET = --set ballast.stiffness=$2e6 --set rail.mass_model=consistent --set rail.elements_per_bay=4
endef
$(foreach r,$(ROUTES),$(foreach b,$(BALLASTS),$(eval $(call track,$r,$b))))

SETTINGS = fast reference grid mesh
define passage
$(SETTINGS:%=$A/%/$1-$2-$3.run): data/cases/diverging-80.yaml $A/$1.veh $A/$2-l.ctab $A/$2-r.ctab
$(patsubst %,$A/%/$1-$2-$3.run,fast reference grid): $A/$2-$3.trk
$A/mesh/$1-$2-$3.run: $A/$2-mesh-$3.trk
endef
$(foreach t,$(TRAINS),$(foreach r,$(ROUTES),$(foreach b,$(BALLASTS),$(eval $(call passage,$t,$r,$b)))))

# What is said of a run must not reach what it is made from, hence private.
QUIET = $(foreach c,bodies pads ballast sleepers rails,--set channels.$c=false)
$(TWELVE:%=$A/fast/%.run): private SET = $(CASE)
$(TWELVE:%=$A/reference/%.run): private SET = $(CASE) --set step=1e-5 --set contact.grid=50
$(TWELVE:%=$A/grid/%.run): private SET = $(CASE) --set contact.grid=50
$(TWELVE:%=$A/mesh/%.run): private SET = $(CASE) --set step=2.5e-5
CASE = --set name=$(basename $(@F)) --set speed_kmh=$(SPEED) --set route=$(word 2,$(subst -, ,$(@F))) $(QUIET)
SPEED = $(if $(findstring diverging,$@),80,$(if $(findstring passenger,$@),200,120))

TABLES = $(foreach s,$(SETTINGS),$(TWELVE:%=$A/$s/%.csv))
$(TABLES): %.csv: %.run
$(TABLES): private POST = --table

# The first against the second.
$A/comparison.csv: $(TWELVE:%=$A/reference/%.csv) $(TWELVE:%=$A/fast/%.csv)
$A/grid.csv: $(TWELVE:%=$A/reference/%.csv) $(TWELVE:%=$A/grid/%.csv)
$A/model.csv: $(TWELVE:%=$A/fast/%.csv) $(TWELVE:%=$A/mesh/%.csv)
$A/comparison.csv $A/grid.csv $A/model.csv: pipelines/accuracy.awk
	awk -f $^ >$@

# The largest difference of each quantity in the zones of the turnout, and in how many of them it is 1 per cent or more.
$A/summary.txt: $A/comparison.csv $A/grid.csv $A/model.csv
	for f in $^; do awk -F, -v f=$$f 'NR > 1 && $$4 != "no zone" {n[$$5]++; d = $$10 < 0 ? -$$10 : $$10; over[$$5] += d >= 1; \
	    if (d >= most[$$5]) {most[$$5] = d; at[$$5] = $$1 " " $$2 " " $$3 ", " $$4}} \
	    END {for (q in n) printf "%-30s %-20s %7.3f %%  %3d of %d  %s\n", f, q, most[q], over[q], n[q], at[q]}' $$f | sort; done >$@
