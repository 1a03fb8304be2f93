# Question: what does each treatment of yaw (none, thesis, exact) say of the contact that touches, and what does a train make of it?
# Figures: contact on wheel and rail, angle, rolling radius at 0, 5, 12 and 24 mrad; S1002 on 60E1 1:40, and in the switch at 6.5 m.  Yaw, lateral
# displacement and contacts of a freight wagon's wheelsets in the switch panel at 80 km/h and in a curve of 190 m at 40 km/h, on moving masses
# (figure 2-j of Lau 2018).
# Time: about 35 s on one core, half of it tables and runs, the rest pictures.
# Headline: u at which the flange touches at 24 mrad, plain rail: none 6.62, thesis 6.36, exact 6.38 mm (out/yaw/errors.txt);
# thesis agrees there by construction, vxcontact(1) says why.  Of the leading wheelset's 3.8 mrad in the switch the treatments differ by 0.02, of its 7.3
# in the steady curve by 0.07 mrad (out/yaw/*-differences.csv).
Y = out/yaw
YAWS = 0 5 12 24

yaw: $Y/turnout.png $Y/turnout-entrance.png $Y/turnout-trailing.png $Y/curve.png $Y/curve-trailing.png $Y/turnout-differences.csv $Y/curve-differences.csv
yaw: $Y/errors.txt $(YAWS:%=$Y/plain-%.png) $(YAWS:%=$Y/switch-%.png) $Y/plain.png $Y/switch.png ## none, thesis and exact compared, into out/yaw
.PHONY: yaw

$Y/wheel-l.prof $Y/wheel-r.prof: data/profiles/S1002.yaml
$Y/plain-r.prof: data/profiles/60E1.yaml
$Y/plain-r.prof: SET = --set cant=0.025
$Y/switch-l.prof: data/turnouts/60E1-R760-1-15.yaml data/profiles/60E1.yaml

PLAIN  = $(addprefix $Y/plain-,none.ctab thesis.ctab exact.ctab)
SWITCH = $(addprefix $Y/switch-,none.ctab thesis.ctab exact.ctab)
$(PLAIN) $Y/plain-own.ctab: $Y/wheel-r.prof $Y/plain-r.prof
$(SWITCH) $Y/switch-own.ctab: $Y/wheel-l.prof $Y/switch-l.prof
$Y/%-none.ctab: YAW = none $(FINE)
$Y/%-thesis.ctab: YAW = thesis --yaw-max 0.024 $(FINE)
$Y/%-exact.ctab: YAW = exact --yaw-max 0.024 --yaws 25 $(FINE)
$Y/%-own.ctab: YAW = thesis $(FINE)
$(PLAIN) $Y/plain-own.ctab: FINE = --u-step 2e-5

# Up to the yaw at which the flange touches the thesis' table is that of its own range, beyond it one up to 24 mrad.
$Y/plain-0.txt $Y/plain-5.txt: $Y/plain-none.ctab $Y/plain-own.ctab $Y/plain-exact.ctab
$Y/plain-12.txt $Y/plain-24.txt: $(PLAIN)
$Y/switch-0.txt $Y/switch-5.txt: $Y/switch-none.ctab $Y/switch-own.ctab $Y/switch-exact.ctab
$Y/switch-12.txt $Y/switch-24.txt: $(SWITCH)
MRAD = $(lastword $(subst -, ,$(basename $(@F))))
$Y/plain-%.txt: ASK = --sweep yaw=$(MRAD)e-3
$Y/switch-%.txt: ASK = --sweep yaw=-$(MRAD)e-3,s=6.5

SWEEPS = $(foreach p,plain switch,$(YAWS:%=$Y/$p-%.txt))
$Y/errors.txt: pipelines/yaw.awk $(SWEEPS)
	awk -f $^ >$@

WINDOW = --size 1400x1400 --from $(if $(findstring plain,$@),0.004 --to 0.008,-0.008 --to -0.004)
WHERE = $(if $(findstring plain,$@),S1002 on 60E1 1:40,Switch of 60E1-R760-1:15 at 6.5 m)
$(SWEEPS:.txt=.png): $Y/%.png: $Y/%.txt
$(SWEEPS:.txt=.png): PLOT = --figure yaw $(WINDOW) --title "$(WHERE), yaw $(MRAD) mrad"
$Y/plain.png: $(YAWS:%=$Y/plain-%.txt)
$Y/switch.png: $(YAWS:%=$Y/switch-%.txt)
$Y/plain.png $Y/switch.png: PLOT = --figure yaw $(WINDOW) $(foreach y,$(YAWS),--label "$y mrad") --title "$(WHERE)"

# ---- A passage: the leading wheelset of the freight train, on a track of moving masses ----

METHODS = none thesis exact
$Y/curve-l.prof $Y/curve-r.prof: data/profiles/60E1.yaml
$Y/curve-l.prof $Y/curve-r.prof: SET = --set cant=0.025
$Y/turnout-l.prof $Y/turnout-r.prof: data/turnouts/60E1-R760-1-15.yaml data/profiles/60E1.yaml
$Y/wagon.veh: data/vehicles/freight-y25-22t5.yaml

# The switch panel of the diverging route, and a curve of 190 m, that of the sharpest turnouts, which begins as theirs do.
$Y/turnout.trk: data/tracks/60E1-R760-1-15-moving-mass.yaml
$Y/curve.trk: data/tracks/moving-mass.yaml
$Y/curve.trk: SET = --set 'curve=[{from: 0, curvature: 5.26315789473684e-3}]'

define yawed
$Y/$1-$2-l.ctab: $Y/wheel-l.prof $Y/$1-l.prof
$Y/$1-$2-r.ctab: $Y/wheel-r.prof $Y/$1-r.prof
$Y/$1-$2-l.ctab $Y/$1-$2-r.ctab: private YAW = $2
$Y/$1-$2.run: data/cases/diverging-80.yaml $Y/$1.trk $Y/wagon.veh $Y/$1-$2-l.ctab $Y/$1-$2-r.ctab
endef
$(foreach p,turnout curve,$(foreach m,$(METHODS),$(eval $(call yawed,$p,$m))))
$(METHODS:%=$Y/turnout-%.run): private SET = $(PASSAGE) --set end=45
$(METHODS:%=$Y/curve-%.run): private SET = $(PASSAGE) --set end=90 --set speed_kmh=40
PASSAGE = --set name=$(basename $(@F)) --set start=-40 --set channels.rails=false

$Y/turnout.png $Y/turnout-entrance.png $Y/turnout-trailing.png: $(METHODS:%=$Y/turnout-%.run)
$Y/curve.png $Y/curve-trailing.png: $(METHODS:%=$Y/curve-%.run)
STEERED = --figure wheelset --size 1600x2000 $(METHODS:%=--label %)
$Y/turnout.png: PLOT = $(STEERED) --from -5 --to 40 --mark '0=front of switch' --mark '1.5=tip of blade' \
    --title 'Leading wheelset in the switch panel, 80 km/h'
$Y/turnout-entrance.png: PLOT = $(STEERED) --from 0 --to 14 --mark '1.5=tip of blade' --title 'Leading wheelset, entrance of the switch panel, 80 km/h'
$Y/turnout-trailing.png: PLOT = $(STEERED) --wheelset 2 --from -5 --to 40 --mark '0=front of switch' --mark '1.5=tip of blade' \
    --title 'Second wheelset in the switch panel, 80 km/h'
$Y/curve.png: PLOT = $(STEERED) --from -5 --to 70 --title 'Leading wheelset in a curve of 190 m, 40 km/h'
$Y/curve-trailing.png: PLOT = $(STEERED) --wheelset 2 --from -5 --to 70 --title 'Second wheelset in a curve of 190 m, 40 km/h'

$Y/turnout-differences.csv: $(METHODS:%=$Y/turnout-%-samples.csv) $Y/turnout-exact.run
$Y/turnout-differences.csv: BETWEEN = 0:12 12:40
$Y/curve-differences.csv: $(METHODS:%=$Y/curve-%-samples.csv) $Y/curve-exact.run
$Y/curve-differences.csv: BETWEEN = 0:10 10:70
