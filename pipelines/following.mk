# Question: what does a track that follows the train leave out of one that is fixed in space?
# Figure: Q of the leading left wheel on straight track and over a dip of 1 mm on 1 m, 80 km/h: full track, moving mass, co-running track.
# Time: about 5 s on one core, half of it contact tables.
# Headline: sleeper passing, 221 N at 37 Hz on the full track, is absent; the dip changes Q 1.20 and 0.88 times as much (tests/pipe/following.t).
F = out/following
FOLLOWING = full mass co-running

following: $F/vertical.png $(FOLLOWING:%=$F/%.csv)  ## full track, moving mass and co-running track over a dip, into out/following
.PHONY: following

$F/wheel-l.prof $F/wheel-r.prof: data/profiles/S1002.yaml
$F/rail-l.prof $F/rail-r.prof: data/profiles/60E1.yaml
$F/plain-l.ctab: $F/wheel-l.prof $F/rail-l.prof
$F/plain-r.ctab: $F/wheel-r.prof $F/rail-r.prof
$F/vehicle.veh: data/vehicles/manchester-passenger.yaml

$F/full.trk: data/tracks/thesis-straight.yaml
$F/full.trk: SET = --set from=-90 --set length=120
$F/mass.trk: data/tracks/moving-mass.yaml
$F/co-running.trk: data/tracks/co-running.yaml

$(FOLLOWING:%=$F/%.run): $F/%.run: data/cases/dip-80.yaml $F/%.trk $F/vehicle.veh $F/plain-l.ctab $F/plain-r.ctab
$(FOLLOWING:%=$F/%.csv): $F/%.csv: $F/%.run
$(FOLLOWING:%=$F/%.csv): POST = --wheels

$F/vertical.png: $(FOLLOWING:%=$F/%.run)
$F/vertical.png: PLOT = --figure vertical --from -6 --to 4 --label "full track" --label "moving mass" --label "co-running track"
