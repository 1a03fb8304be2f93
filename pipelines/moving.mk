# Question: what does a track of moving masses say of a train in a turnout, beside the full track?
# Figures: Q and Y of the leading wheelset through the diverging route at 80 km/h on both tracks, and the spectrum of Q before the turnout
# (figures 6 to 8 of Lau and Hoff 2018).
# Time: about 10 s on one core.
# Headline: sleeper passing, 369 N at 37 Hz on the full track, 1e-7 N on moving masses (out/moving/spectrum.txt); in the closure panel Q of the
# leading left wheel differs by 0.58 kN rms of 118 kN, Y by 1.3 of 20 (out/moving/turnout-differences.csv).
G = out/moving
TRACKS = full mass

moving: $(addprefix $G/,vertical.png lateral.png crossing.png spectrum.png turnout-differences.csv $(TRACKS:%=%-wheels.csv)) ## full track and moving masses through a turnout, into out/moving
.PHONY: moving

$G/wheel-l.prof $G/wheel-r.prof: data/profiles/S1002.yaml
$G/turnout-l.prof $G/turnout-r.prof: data/turnouts/60E1-R760-1-15.yaml data/profiles/60E1.yaml
$G/turnout-l.ctab: $G/wheel-l.prof $G/turnout-l.prof
$G/turnout-r.ctab: $G/wheel-r.prof $G/turnout-r.prof
$G/full.trk: data/tracks/60E1-R760-1-15-diverging.yaml
$G/mass.trk: data/tracks/60E1-R760-1-15-moving-mass.yaml
$G/vehicle.veh: data/vehicles/passenger-19t.yaml

$(TRACKS:%=$G/%.run): $G/%.run: data/cases/diverging-80.yaml $G/%.trk $G/vehicle.veh $G/turnout-l.ctab $G/turnout-r.ctab
$(TRACKS:%=$G/%.run): private SET = --set name=$(basename $(@F)) --set sampling=2000 --set channels.rails=false
$(TRACKS:%=$G/%-wheels.csv): $G/%-wheels.csv: $G/%.run
$(TRACKS:%=$G/%-wheels.csv): POST = --wheels

# Switch, closure and crossing panel, and the run-in once the start has died away.
$G/turnout-differences.csv: $G/mass-samples.csv $G/full-samples.csv $G/full.run
$G/turnout-differences.csv: BETWEEN = -45:-3 0:12 12:43 43:54

$G/%-Q.csv: $G/%.run $(BIN)/vxdump
	$(BIN)/vxdump --csv -o $@ $< station wheel.Q
$G/spectrum.txt: pipelines/spectrum.awk $G/full-Q.csv $G/mass-Q.csv
	awk -v from=-45 -v to=-3 -v v=22.2222 -v name="full_track moving_mass" -f $^ >$@
$G/spectrum.png: $G/spectrum.txt
$G/spectrum.png: PLOT = --figure table --title 'Spectrum of Q, wheel 1 left, from −45 to −3 m at 80 km/h' --mark '37.04=sleepers'

BESIDE = --label 'full track' --label 'moving mass'
$G/vertical.png $G/lateral.png $G/crossing.png: $G/full.run $G/mass.run
$G/vertical.png: PLOT = --figure vertical $(BESIDE) --from -10 $(PANELS)
$G/lateral.png: PLOT = --figure lateral $(BESIDE) --from -10 $(PANELS)
$G/crossing.png: PLOT = --figure vertical $(BESIDE) --from 43 --to 52 --mark '46.7=nose'
