"""What the Esso Osaka model on the pond lacks where its wind is not told, and whether the diagnosis finds that wind.

The recordings (FRT-DS-ESSO, CC BY-NC 4.0) are not part of swayaw:

    python3 python/examples/esso_osaka_wind.py TURN.csv…
"""

import sys

import numpy

import swayaw

def without_wind(run: swayaw.Recording) -> swayaw.Recording:
    """The same run, as if the wind had not been measured."""
    return swayaw.Recording.from_dataframe(run.to_dataframe().drop(columns=["wind_speed_m_s", "wind_from_rad"]))


runs = [swayaw.read_csv(file) for file in sys.argv[1:]]
for run in runs:
    wind = numpy.mean(run["wind_speed_m_s"] * numpy.exp(1j * run["wind_from_rad"]))
    print(f"{run.name}: wind {abs(wind):.2f} m/s from {numpy.degrees(numpy.angle(wind)) % 360:.0f} deg as measured")

ship = swayaw.published_ship("esso_osaka_3m")
result = swayaw.diagnose(ship, [without_wind(run) for run in runs], progress=lambda words: print("…", words))
print(result.words)
for effect in result.effects:
    print(f"{effect.effect.label}, probability {effect.probability:.3f}:", end=" ")
    print(", ".join(f"{p.key} {p.value:.3g} ± {p.standard_error:.1g}" for p in effect.parameters))
for candidate in result.candidates[:5]:
    print(f"  {candidate.effect:24} gain in log evidence {candidate.log_evidence_gain:8.1f}")
