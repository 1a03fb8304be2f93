# Question: what are receptance, modes and static stiffness of the straight track of Table 1 and of a turnout?
# Figures: receptance above a sleeper and between two, by the thesis' formula and exactly (figure 2 of Lau and Hoff 2018), and by a hammer
# in time; three modes (figure 3); a moving mass beside them (figure 4); stiffness along the turnout.  Time: about 3 s on one core, most of it pictures.
# Headline: peaks at 119, 486 and 907 Hz (out/track/receptance.png); the left rail's stiffness rises from 200 to
# 253 MN/m over the crossing, the right one's falls to 147 (out/track/stiffness.png).
K = out/track

track: $(addprefix $K/,receptance.png hammer.png moving-mass.png modes.png stiffness.png)  ## receptance, modes and stiffness of a track, into out/track
.PHONY: track

$K/straight.trk: data/tracks/thesis-straight.yaml
$K/turnout.trk: data/tracks/60E1-R760-1-15-diverging.yaml

$K/sleeper.frf $K/midspan.frf: $K/straight.trk
$K/sleeper.frf: RECEPTANCE = --at sleeper
$K/midspan.frf: RECEPTANCE = --at midspan
$K/receptance.png: $K/sleeper.frf $K/midspan.frf
$K/receptance.png: PLOT = --figure receptance

# The same above a sleeper by a hammer in time: a step of 1e-5 s, four blows.
$K/hammer.run: data/cases/hammer.yaml $K/straight.trk $(BIN)/vxrun
	$(BIN)/vxrun --track $(call of,.trk) -o $@ $<
$K/hammer.frf: $K/hammer.run $(BIN)/vxtransfer
	$(BIN)/vxtransfer --segment 1 -o $@ $<
$K/hammer.png: $K/sleeper.frf $K/hammer.frf
$K/hammer.png: PLOT = --figure receptance --label "direct" --label "hammer, in time"

# Both rails loaded.
$K/moving-mass.trk: data/tracks/moving-mass.yaml
$K/mass.frf: $K/moving-mass.trk
$K/mass.frf: RECEPTANCE = --at sleeper
$K/moving-mass.png: $K/sleeper.frf $K/mass.frf
$K/moving-mass.png: PLOT = --figure receptance --label "beam" --label "moving mass"

# The modes in phase that the article names.
$K/ballast.mod $K/pads.mod $K/bays.mod: $K/straight.trk
$K/ballast.mod: MODES = 1 --near 129.01
$K/pads.mod: MODES = 1 --near 505.06
$K/bays.mod: MODES = 1 --near 825.4
$K/modes.png: $K/straight.trk $K/ballast.mod $K/pads.mod $K/bays.mod
$K/modes.png: PLOT = --figure modes

$K/stiffness.txt: $K/turnout.trk $(BIN)/vxfreq
	$(BIN)/vxfreq --stiffness $< >$@
$K/stiffness.png: $K/stiffness.txt
$K/stiffness.png: PLOT = --figure stiffness --from -10 --to 60
