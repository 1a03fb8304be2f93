# Question: what does each treatment of yaw (none, thesis, exact) say of the contact that touches, over lateral displacement?
# Figures: contact on wheel and rail, angle, rolling radius at 0, 5, 12 and 24 mrad; S1002 on 60E1 1:40, and in the switch at 6.5 m.
# Time: about 10 s on one core, most of it pictures.
# Headline: u at which the flange touches at 24 mrad, plain rail: none 6.62, thesis 6.36, exact 6.38 mm (out/yaw/errors.txt);
# thesis agrees there by construction, vxcontact(1) says why.
Y = out/yaw
YAWS = 0 5 12 24

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
