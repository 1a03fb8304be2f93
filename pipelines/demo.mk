# Question: what does a passenger train at 80 km/h put on the diverging route of a 60E1-R760-1:15 turnout?
# Figures: wheel, pad and ballast forces along the turnout, sections, contact, receptance (figures 2, 6, 9 to 12 of Lau and Hoff's papers).
# Time: about 10 s on one core, most of it pictures.
# Headline: largest Q of the leading left wheel, at the crossing: 103 kN on 54.5 kN static (out/demo/wheels.csv).
include pipelines/rules.mk

D = out/demo
DEMO = $(addprefix $D/,sections.png switch-contact.png crossing-contact.png crossing-sequence.png crossing-path.png contact-jump.png \
       rolling-radius.png conicity.png receptance.png vertical.png lateral.png pads.png ballast.png max-pads.png max-ballast.png \
       zones.csv sleepers.csv wheels.csv balance.csv)

demo: $(DEMO) $(PROGRAMS)               ## the main job: a train through a turnout, into out/demo

# Profiles: the wheel, the turnout's sections, and plain rail inclined 1:40 to look at contact on its own.
$D/wheel-l.prof $D/wheel-r.prof: data/profiles/S1002.yaml
$D/turnout-l.prof $D/turnout-r.prof: data/turnouts/60E1-R760-1-15.yaml data/profiles/60E1.yaml
$D/rail40-l.prof $D/rail40-r.prof: data/profiles/60E1.yaml
$D/rail40-l.prof $D/rail40-r.prof: SET = --set cant=0.025

$D/turnout-l.ctab: $D/wheel-l.prof $D/turnout-l.prof
$D/turnout-r.ctab: $D/wheel-r.prof $D/turnout-r.prof
$D/rail40-l.ctab: $D/wheel-l.prof $D/rail40-l.prof
$D/rail40-r.ctab: $D/wheel-r.prof $D/rail40-r.prof

$D/track.trk: data/tracks/60E1-R760-1-15-diverging.yaml
$D/straight.trk: data/tracks/thesis-straight.yaml
$D/vehicle.veh: data/vehicles/manchester-passenger.yaml

$D/sleeper.frf $D/midspan.frf: $D/straight.trk
$D/sleeper.frf: RECEPTANCE = --excite both --at sleeper --from 10 --to 1500 --step 1
$D/midspan.frf: RECEPTANCE = --excite both --at midspan --from 10 --to 1500 --step 1

$D/diverging.run: data/cases/diverging-80.yaml $D/track.trk $D/vehicle.veh $D/turnout-l.ctab $D/turnout-r.ctab

$D/zones.csv $D/sleepers.csv $D/wheels.csv $D/balance.csv: $D/diverging.run
$D/zones.csv: POST = --table
$D/sleepers.csv: POST = --sleepers
$D/wheels.csv: POST = --wheels
$D/balance.csv: POST = --balance

$D/sections.png: $D/turnout-l.prof
$D/sections.png: PLOT = --figure sections
$D/switch-contact.png $D/crossing-contact.png: $D/wheel-l.prof $D/turnout-l.prof $D/turnout-l.ctab
$D/switch-contact.png: PLOT = --figure contact --station 6.5 --u -0.005 --yaw -0.002
$D/crossing-contact.png: PLOT = --figure contact --station 47.2 --u -0.0035 --yaw -0.002
$D/crossing-sequence.png: $D/wheel-l.prof $D/turnout-l.prof $D/turnout-l.ctab
$D/crossing-sequence.png: PLOT = --size 1600x1050 --figure sequence --from 46.8 --to 47.35 --u -0.0035 --yaw -0.002
PATHS = $(US:%=$D/crossing-path%.txt)
US = -4 -2 +0 +2 +4
$(PATHS): $D/turnout-l.ctab
$(PATHS): ASK = --path u=$(@:$D/crossing-path%.txt=%)e-3,from=46,to=48,step=0.002,yaw=-0.002
$D/crossing-path.png: $(PATHS)
$D/crossing-path.png: PLOT = --size 1600x1100 --figure path $(foreach u,$(US),--label "$(u:+%=%) mm") \
    --title "Path of the left wheel at five u, and its kink; yaw −2 mrad"
$D/contact-jump.png: $D/wheel-r.prof $D/rail40-r.prof $D/rail40-r.ctab
$D/contact-jump.png: PLOT = --figure pairs
$D/rolling-radius.png: $D/rail40-l.ctab $D/rail40-r.ctab
$D/rolling-radius.png: PLOT = --figure radius --from -0.0075 --to 0.0075
$D/conicity.txt: $D/rail40-l.ctab $D/rail40-r.ctab
$D/conicity.txt: ASK = --conicity 0.001,0.0015,0.002,0.0025,0.003,0.0035,0.004,0.0045,0.005,0.0055,0.006
$D/conicity.png: $D/conicity.txt
$D/conicity.png: PLOT = --figure conicity
$D/receptance.png: $D/sleeper.frf $D/midspan.frf
$D/receptance.png: PLOT = --figure receptance

$(addprefix $D/,vertical.png lateral.png pads.png ballast.png max-pads.png max-ballast.png): $D/diverging.run
$D/vertical.png: PLOT = --figure vertical $(PANELS)
$D/lateral.png: PLOT = --figure lateral $(PANELS)
$D/pads.png: PLOT = --figure pads --from -5 --to 55 --sleeper 2 --sleeper 40 --sleeper 80
$D/ballast.png: PLOT = --figure ballast --from -5 --to 55 --sleeper 2 --sleeper 40 --sleeper 80
$D/max-pads.png: PLOT = --figure max-pads --from -20 $(SEATS)
$D/max-ballast.png: PLOT = --figure max-ballast --from -20 $(SEATS)
PANELS = --mark '0=front of switch' --mark '47=nose'
SEATS = --mark '1=switch' --mark '79=nose'

# The pictures of the README are copies: made anew by hand when they should change.
pictures: $D/vertical.png $D/crossing-contact.png $D/receptance.png ## renew the pictures of the README
	@mkdir -p man/pictures
	cp $^ man/pictures
.PHONY: pictures
