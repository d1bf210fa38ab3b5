# Made by python/stubs/make_stubs.py from the docstrings of the module.
from os import PathLike
from types import ModuleType
from typing import Any, Callable, Dict, Iterator, List, Mapping, NamedTuple, Optional, Set, Tuple, Union, overload

import numpy
from numpy.typing import ArrayLike

__version__: str
figures: ModuleType

class Advice:
    """What to sail next."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Advice: ...
    @property
    def advice(self) -> str:
        """A manoeuvre in words."""
    @property
    def separates(self) -> List[str]:
        """Effects that it tells apart."""

class Approach:
    """The ship before the first rudder order."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Approach: ...
    @property
    def before(self) -> float:
        """Recorded time before the execute [s]."""
    @property
    def execute(self) -> Told:
        """When the rudder begins to move [s]."""
    @property
    def execute_said(self) -> bool:
        """By the run itself."""
    @property
    def heading(self) -> Told:
        """[rad]"""
    @property
    def rudder(self) -> float:
        """Mean angle, positive to port [rad]."""
    @property
    def speed(self) -> Optional[Told]:
        """[m/s]"""
    @property
    def speed_source(self) -> str:
        """Where the speed comes from."""

class BaselineShift:
    """A number of the baseline that is off by more than two of its deviations."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> BaselineShift: ...
    @property
    def deviations(self) -> float: ...
    @property
    def given(self) -> float:
        """SI"""
    @property
    def key(self) -> str:
        """Of ship files."""
    @property
    def part(self) -> str:
        """Of the ship: "rudder"."""
    @property
    def refitted(self) -> float:
        """SI"""

class Candidate:
    """An effect that was tried alone."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Candidate: ...
    @property
    def as_form(self) -> bool:
        """An error in the form of her forces explains the runs as well."""
    @property
    def effect(self) -> str:
        """Its id."""
    @property
    def holdout_gain(self) -> Optional[float]:
        """Fall of the replay errors of held-out runs."""
    @property
    def holdout_log_likelihood_gain(self) -> Optional[float]:
        """Of the held-out runs."""
    @property
    def log_evidence_gain(self) -> float: ...
    @property
    def probability(self) -> float: ...
    @property
    def refuted(self) -> bool:
        """By runs that were not used."""
    @property
    def too_large(self) -> bool:
        """Larger than it can be: something else acts like it."""
    @property
    def trace(self) -> bool:
        """Too small to matter, or not told from nothing."""

class CaptiveError:
    """Model less measurement, as primes over ½ρL²U² and ½ρL³U²; NaN without any."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> CaptiveError: ...
    @property
    def measured(self) -> PlanarForce:
        """Rms of what was measured."""
    @property
    def points(self) -> int:
        """How many."""
    @property
    def relative(self) -> PlanarForce:
        """rms of the error over that of the measurement."""
    @property
    def rms(self) -> PlanarForce:
        """Of model less measured."""

class CaptiveFit:
    """A ship from captive tests."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> CaptiveFit: ...
    @property
    def ship(self) -> Ship:
        """With the coefficients found."""
    @property
    def steps(self) -> List[CaptiveStepReport]:
        """In their order."""
    @property
    def validation(self) -> CaptiveError:
        """After the last step."""

class CaptiveMoment:
    """A moment of a captive test."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> CaptiveMoment: ...
    def __init__(self, motion: PlanarMotion = ..., acceleration: PlanarAcceleration = ..., controls: Controls = ..., weight: float = ...) -> None: ...
    @property
    def acceleration(self) -> PlanarAcceleration:
        """Likewise."""
    @property
    def controls(self) -> Controls:
        """Rudder and propulsion."""
    @property
    def motion(self) -> PlanarMotion:
        """That the carriage imposes."""
    @property
    def weight(self) -> float:
        """Forces of a test are Σ weight × force over its moments."""

class CaptivePlan:
    """Steps in their order: what one has found is known to the next."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> CaptivePlan: ...
    def __init__(self, steps: List[CaptiveStep] = ..., validation: CaptiveSelection = ...) -> None: ...
    @property
    def steps(self) -> List[CaptiveStep]:
        """In their order."""
    @property
    def validation(self) -> CaptiveSelection:
        """Points that no step may use."""

class CaptivePoint:
    """One measurement of a captive test."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> CaptivePoint: ...
    def __init__(self, run: str = ..., tests: List[str] = ..., moments: List[CaptiveMoment] = ..., measured: PlanarForce = ..., with_inertia: bool = ...) -> None: ...
    @property
    def measured(self) -> PlanarForce:
        """About midship [N, N m]; NaN where it was not measured."""
    @property
    def moments(self) -> List[CaptiveMoment]:
        """One for a steady test, a cycle for a Fourier coefficient."""
    @property
    def run(self) -> str:
        """Its name."""
    @property
    def tests(self) -> List[str]:
        """Kinds of test it belongs to: "static_drift", "pure_yaw:velocity"."""
    @property
    def with_inertia(self) -> bool:
        """The force that accelerates the model is still in it."""

class CaptiveSelection:
    """Which points of captive tests."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> CaptiveSelection: ...
    def __init__(self, tests: List[str] = ..., max_drift: float = ..., max_rudder: float = ..., min_rudder: float = ..., min_speed: float = ..., without_runs: List[str] = ...) -> None: ...
    @property
    def max_drift(self) -> float:
        """[rad]"""
    @property
    def max_rudder(self) -> float:
        """[rad]"""
    @property
    def min_rudder(self) -> float:
        """[rad]"""
    @property
    def min_speed(self) -> float:
        """[m/s]"""
    @property
    def tests(self) -> List[str]:
        """Of one of these kinds; empty for every kind."""
    @property
    def without_runs(self) -> List[str]:
        """Names."""

class CaptiveStep:
    """Some coefficients from some captive tests."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> CaptiveStep: ...
    def __init__(self, points: CaptiveSelection = ..., component: str = ..., coefficients: List[str] = ...) -> None: ...
    @property
    def coefficients(self) -> List[str]:
        """Keys of the ship file."""
    @property
    def component(self) -> str:
        """X, Y or N."""
    @property
    def points(self) -> CaptiveSelection:
        """Which, a CaptiveSelection."""

class CaptiveStepReport:
    """What a step found."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> CaptiveStepReport: ...
    @property
    def fit(self) -> Regression:
        """Of primes; coefficients in SI or as the primes they are."""
    @property
    def points(self) -> int:
        """How many it used."""
    @property
    def step(self) -> CaptiveStep:
        """As planned."""
    @property
    def validation(self) -> CaptiveError:
        """Of the ship with what is found so far."""

class Channel(NamedTuple):
    """What a recording can hold."""
    name: str
    column: str
    units: dict[str, float]
    shows_motion: bool

class ChannelCharacter:
    """What the samples of a channel are like."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ChannelCharacter: ...
    @property
    def channel(self) -> str:
        """By its short name."""
    @property
    def interpolated(self) -> bool:
        """Samples between fixes are on straight lines."""
    @property
    def interval(self) -> float:
        """Mean time between samples that were measured [s]."""
    @property
    def measured(self) -> List[int]:
        """Places of samples that were really measured."""
    @property
    def noise(self) -> float:
        """Standard deviation of the white part."""
    @property
    def outliers(self) -> List[int]:
        """Places of single samples far from both neighbours."""
    @property
    def samples(self) -> int:
        """With a value."""
    @property
    def step(self) -> float:
        """Of rounding; 0 if none is seen."""

class ChannelInnovation:
    """How well the prediction of a channel from the past agreed with it."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ChannelInnovation: ...
    @property
    def autocorrelation(self) -> float:
        """Of successive ones: 0 for a right filter."""
    @property
    def channel(self) -> str:
        """By its short name."""
    @property
    def count(self) -> int: ...
    @property
    def noise(self) -> float:
        """Standard deviation, known or estimated, SI."""
    @property
    def rms(self) -> float:
        """Of prediction errors over their expected size: 1 for a right filter."""

class ChannelNoise:
    """Standard deviations of white measurement noise."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ChannelNoise: ...
    @property
    def beta(self) -> float:
        """[rad]"""
    @property
    def psi(self) -> float:
        """[rad]"""
    @property
    def r(self) -> float:
        """[rad/s]"""

class ChannelResiduals:
    """What a run leaves unexplained in a channel, SI."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ChannelResiduals: ...
    @property
    def after(self) -> float:
        """Rms with the fitted ship."""
    @property
    def autocorrelation(self) -> float:
        """Near 0 where the model and the noise are right."""
    @property
    def before(self) -> float:
        """Rms with the ship that was given."""
    @property
    def channel(self) -> str:
        """By its short name."""
    @property
    def count(self) -> int: ...
    @property
    def effective_count(self) -> float: ...

class CircleTold:
    """Lengths of a recorded turning circle."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> CircleTold: ...
    @property
    def advance(self) -> Optional[Told]:
        """At 90 deg [m]."""
    @property
    def final_diameter(self) -> Optional[Told]:
        """Of the steady turn [m]."""
    @property
    def initial_turning(self) -> Optional[Told]:
        """Way made at 10 deg [m]."""
    @property
    def tactical_diameter(self) -> Optional[Told]:
        """At 180 deg [m]."""
    @property
    def transfer(self) -> Optional[Told]:
        """At 90 deg [m]."""

class Coefficient:
    """A coefficient and what the data tell of it."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Coefficient: ...
    @property
    def attenuation(self) -> float:
        """What errors of the features take of it."""
    @property
    def estimate(self) -> Estimate:
        """In the unit of the ship file."""
    @property
    def high(self) -> float:
        """95 % interval."""
    @property
    def low(self) -> float:
        """95 % interval."""
    @property
    def name(self) -> str:
        """Key of the ship file."""
    @property
    def undetermined(self) -> bool:
        """It could change so much that its force were half of all."""
    @property
    def variance_inflation(self) -> float:
        """1 where it is orthogonal to all others."""

class CoefficientEstimates:
    """Fitted coefficients of the coupled equations, dimensionless."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> CoefficientEstimates: ...
    @property
    def a1(self) -> Estimate: ...
    @property
    def a2(self) -> Estimate: ...
    @property
    def b1(self) -> Estimate: ...
    @property
    def b2(self) -> Estimate: ...
    @property
    def c1(self) -> Estimate: ...
    @property
    def c2(self) -> Estimate: ...

class Combination:
    """A sum of coefficients that data do not determine."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Combination: ...
    @property
    def standard_error(self) -> float:
        """Over the rms of y; infinite where y does not see it."""
    @property
    def terms(self) -> List[Tuple[str, float]]:
        """Names and weights of coefficient times rms of its column, largest 1."""
    @property
    def words(self) -> str:
        """\"Y_v - 0.98 Y_r\""""

class Comparison:
    """One run beside its simulations, which share its times."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Comparison: ...
    def __getitem__(self: Any, arg0: str) -> Any: ...
    def _repr_html_(self) -> str: ...
    @property
    def conditions(self) -> Conditions:
        """Motion and rudder."""
    @property
    def errors(self) -> List[QuantityError]:
        """Of every quantity that the run tells."""
    @property
    def open_loop(self) -> Recording:
        """Simulated from its start to its end."""
    def plot(result, axes=...) -> Any:
        """Recorded and simulated, from the start and restarted every two ship lengths; the worst interval is shaded."""
    @property
    def recorded(self) -> Recording:
        """The run."""
    @property
    def restarted(self) -> Recording:
        """Simulated window after window."""
    @property
    def window_starts(self) -> List[int]:
        """First sample of each window."""

class Conditions:
    """Motion and rudder of every sample."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Conditions: ...
    @property
    def drift(self) -> numpy.ndarray:
        """beta [rad]."""
    @property
    def rudder(self) -> numpy.ndarray:
        """Positive to port [rad]."""
    @property
    def yaw_rate(self) -> numpy.ndarray:
        """rL/U."""

class Controls:
    """What the bridge and the engine room do to the ship."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Controls: ...
    def __init__(self, delta: float = ..., rev: float = ..., thrust: Thrust = ..., by_thrust: bool = ...) -> None: ...
    @property
    def by_thrust(self) -> bool:
        """Whether the thrust counts."""
    @property
    def delta(self) -> float:
        """Rudder angle, positive to port [rad]."""
    @property
    def rev(self) -> float:
        """Shaft speed [1/s]."""
    @property
    def thrust(self) -> Thrust:
        """In place of the shaft speed [N]."""

class Criterion:
    """One number that must not be exceeded."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Criterion: ...
    @property
    def limit(self) -> float:
        """In `unit`."""
    @property
    def name(self) -> str:
        """\"tactical_diameter\""""
    @property
    def passed(self) -> Optional[bool]:
        """None without a value."""
    @property
    def side(self) -> str:
        """Turned to first."""
    @property
    def unit(self) -> str:
        """\"L", ship lengths, or "deg"."""
    @property
    def value(self) -> Optional[float]:
        """In `unit`; None where the manoeuvre did not come so far."""

class Crossover:
    """Where a helmsman's loop has gain 1."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Crossover: ...
    @property
    def frequency(self) -> float:
        """Radians per ship length."""
    @property
    def phase_margin(self) -> float:
        """By which the phase of the loop is above -π [rad]."""

class DateEstimate:
    """A date with the interval that holds it in 95 of 100 cases."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> DateEstimate: ...
    @property
    def begin(self) -> float:
        """Days since 1970-01-01."""
    @property
    def end(self) -> float:
        """Days since 1970-01-01."""
    @property
    def likeliest(self) -> float:
        """Days since 1970-01-01."""

class DayLevel:
    """A parameter on one day of a vessel, all else as she is."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> DayLevel: ...
    @property
    def day(self) -> float:
        """Days since 1970-01-01."""
    @property
    def standard_error(self) -> float:
        """SI, with the scatter between days."""
    @property
    def value(self) -> float:
        """SI"""

class DerivedChannel:
    """A channel that was not measured."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> DerivedChannel: ...
    @property
    def channel(self) -> str:
        """By its short name."""
    @property
    def made_of(self) -> str:
        """What it was made of."""

class DetectableSize:
    """Number of an effect at which these runs would have shown it."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> DetectableSize: ...
    @property
    def effect(self) -> str:
        """Its id."""
    @property
    def key(self) -> str:
        """Of ship files, unit in the name."""
    @property
    def value(self) -> float:
        """In that unit."""

class Diagnosis:
    """What a model left out, and the proof."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Diagnosis: ...
    def _repr_html_(self) -> str: ...
    @property
    def as_form(self) -> List[str]:
        """Effects that an error in the form of her forces explains as well."""
    @property
    def assumed(self) -> List[str]:
        """In place of what the runs do not tell, in words."""
    @property
    def budget(self) -> List[ForceBudget]:
        """Shares by what they follow."""
    @property
    def candidates(self) -> List[Candidate]:
        """Best first."""
    @property
    def detectable(self) -> List[DetectableSize]:
        """Smallest sizes that these runs would have shown."""
    @property
    def discrepancy(self) -> Optional[Discrepancy]:
        """None where no run tells a yaw rate."""
    @property
    def effects(self) -> List[FoundEffect]:
        """Most important first."""
    @property
    def holdout(self) -> List[RunErrors]:
        """Errors in those held out."""
    @property
    def holdout_pictures(self) -> List[RunPicture]:
        """If asked for."""
    @property
    def improved(self) -> Ship:
        """The ship with the effects found."""
    @property
    def instruments(self) -> List[InstrumentEstimate]:
        """Told from none, beside the effects."""
    @property
    def linear(self) -> List[LinearView]:
        """Zigzags and the refitted ship, by K, T and the drift–yaw loop."""
    @property
    def location(self) -> List[MismatchPlace]:
        """Where force is missing."""
    @property
    def moved(self) -> Optional[MovedPart]:
        """None where no part alone helps."""
    @property
    def next_manoeuvre(self) -> Optional[Advice]:
        """What to sail next."""
    def plot(result, axes=...) -> Any:
        """Track and yaw rate of each run beside its replays by the ship as given and with the effects found; the runs must
        have been asked for: diagnose(…, pictures=True)."""
    @property
    def prior_inflation(self) -> float:
        """Factor on what the baseline is known to."""
    @property
    def process_noise(self) -> float:
        """Scale of what stays unexplained; 1 is ordinary."""
    @property
    def refitted(self) -> Ship:
        """Baseline refitted, without effects."""
    @property
    def refitted_process_noise(self) -> float:
        """The same without any effect."""
    @property
    def rudder_force(self) -> Optional[float]:
        """Over that as given, where its numbers are among the shifts."""
    @property
    def runs_in_waves(self) -> float:
        """Share of the runs used that waves move."""
    @property
    def shifts(self) -> List[BaselineShift]:
        """Largest first."""
    @property
    def surroundings(self) -> List[SurroundingsEstimate]:
        """Where wind or stream was found."""
    @property
    def symmetry(self) -> str:
        """What the missing force goes with besides the motion, in words."""
    @property
    def too_large(self) -> List[str]:
        """Effects that something acts like, larger than they can be."""
    @property
    def traces(self) -> List[str]:
        """Effects too small to matter, in words."""
    @property
    def train(self) -> List[RunErrors]:
        """Errors in the runs that were used."""
    @property
    def train_pictures(self) -> List[RunPicture]:
        """If asked for."""
    @property
    def troubles(self) -> List[str]:
        """Steps that failed, in words."""
    @property
    def verdict(self) -> str:
        """missing_physics, nothing_missing or unexplained."""
    @property
    def words(self) -> str:
        """One sentence."""

class DimensionalIndices:
    """Steering indices with dimension."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> DimensionalIndices: ...
    @property
    def Kb(self) -> float:
        """[-]"""
    @property
    def Kr_per_s(self) -> float:
        """Yaw rate per rudder angle [1/s]."""
    @property
    def T1T2_s2(self) -> float:
        """[s²]"""
    @property
    def T1_plus_T2_s(self) -> float:
        """[s]"""
    @property
    def T3b_s(self) -> float:
        """[s]"""
    @property
    def T3w_s(self) -> float:
        """[s]"""
    def __init__(self, T1T2_s2: float = ..., T1_plus_T2_s: float = ..., T3b_s: float = ..., T3w_s: float = ..., Kb: float = ..., Kr_per_s: float = ...) -> None: ...

class DimensionalSwayYaw:
    """The coupled equations in seconds, for v = -U beta and r:
    
    dv/dt = v_v v + v_r r + v_delta delta,   dr/dt = r_v v + r_r r + r_delta delta"""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> DimensionalSwayYaw: ...
    def __init__(self, v_v: float = ..., v_r: float = ..., v_delta: float = ..., r_v: float = ..., r_r: float = ..., r_delta: float = ...) -> None: ...
    @property
    def r_delta(self) -> float:
        """[1/s²]"""
    @property
    def r_r(self) -> float:
        """[1/s]"""
    @property
    def r_v(self) -> float:
        """[1/(m s)]"""
    def state_space(self, heading: bool = ...) -> StateSpace:
        """The coupled equations in seconds: states v [m/s], r [rad/s], and psi where `heading` asks for it."""
    @property
    def v_delta(self) -> float:
        """[m/s²]"""
    @property
    def v_r(self) -> float:
        """[m/s]"""
    @property
    def v_v(self) -> float:
        """[1/s]"""

class Discrepancy:
    """Error of the yaw rate over its variation, mean of all runs."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Discrepancy: ...
    @property
    def after(self) -> float:
        """With the effects."""
    @property
    def given(self) -> float:
        """Of the ship as given."""
    @property
    def refitted(self) -> float:
        """Refitted."""

class Disturbance:
    """Random forces, by what an undisturbed state gains in deviation."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Disturbance: ...
    @property
    def beta(self) -> float:
        """[rad] per root of a ship length."""
    @property
    def omega(self) -> float:
        """Of omega', per root of a ship length."""

class DriftTold:
    """Drift of the track over ground, of current and wind together."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> DriftTold: ...
    @property
    def direction(self) -> Told:
        """To which it sets, clockwise from north [rad]."""
    @property
    def east(self) -> Told:
        """[m/s]"""
    @property
    def north(self) -> Told:
        """[m/s]"""
    @property
    def pairs(self) -> int:
        """Of places with headings 360 deg apart."""
    @property
    def speed(self) -> Told:
        """[m/s]"""

class Effect:
    """Physics that a model leaves out, as a value; docs/effects.md tells all kinds."""
    def __init__(self: Effect, id: str, **kwargs) -> None:
        """From its id and its numbers by their keys in ship files: Effect("steady_wind", wind_speed_m_s=11.2, wind_from_rad=2.09). Raises ValueError for numbers that are not known, missing or out of range."""
    @property
    def id(self) -> str: ...
    @property
    def is_null(self) -> bool:
        """Whether it does nothing."""
    @property
    def label(self) -> str:
        """\"steady wind", "late channel (rudder)\""""
    @property
    def law(self) -> str:
        """What it does, as Markdown."""
    @property
    def numbers(self) -> dict:
        """By their keys, units in the names."""
    def parameters(self: Effect, ship: Ship) -> dict:
        """Its parameters on a ship by name, with range and prior; none if it cannot act on her."""
    @property
    def place(self) -> str:
        """air, water, force, actuator or sensor."""
    @property
    def scope(self) -> str: ...

class Estimate:
    """A number with its standard error; NaN, with infinite error, where data do not tell it."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Estimate: ...
    def __float__(self: Estimate) -> float: ...
    @property
    def standard_error(self) -> float: ...
    @property
    def value(self) -> float: ...
    @property
    def verdict(self) -> str:
        """determined, weakly determined or not determined."""

class EstimatedForce:
    """A force with its covariance."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> EstimatedForce: ...
    @property
    def covariance(self) -> numpy.ndarray:
        """Of X, Y, N: 3 by 3."""
    @property
    def force(self) -> PlanarForce:
        """[N, N, N m]"""

class EstimatedShip:
    """A ship from main dimensions, and what was assumed about her."""
    @property
    def assumptions(self) -> List[str]: ...
    @property
    def warnings(self) -> List[str]:
        """Ratios of the hull that lie outside the range of the formulas."""

class FileError(Refusal):
    """A file that cannot be read: "FILE:LINE:COLUMN: what is wrong"."""
    file: str
    line: int
    column: int

class FirstOrder:
    """Nomoto's first-order equation T d(omega')/ds' + omega' = K delta."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> FirstOrder: ...
    @property
    def K(self) -> float:
        """Gain."""
    @property
    def T(self) -> float:
        """Time constant."""
    def __init__(self, K: float = ..., T: float = ...) -> None: ...

class FittedParameter:
    """A parameter before and after a fit, SI."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> FittedParameter: ...
    @property
    def at_bound(self) -> bool:
        """The value is the last one that her model accepts."""
    @property
    def before(self) -> float:
        """In the ship that was given."""
    @property
    def estimate(self) -> Estimate: ...
    @property
    def name(self) -> str:
        """Key of the ship file."""

class FittedRun:
    """A run of a trajectory fit."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> FittedRun: ...
    @property
    def channels(self) -> List[ChannelResiduals]: ...
    @property
    def name(self) -> str: ...
    @property
    def start(self) -> ShipState:
        """Fitted, at the first sample."""

class FleetDiagnosis:
    """What sisters have in common, and what changed on which of them."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> FleetDiagnosis: ...
    @property
    def day_to_day(self) -> float:
        """The same between days of a vessel."""
    @property
    def shared(self) -> List[SharedCoefficient]:
        """Coefficients of the class."""
    @property
    def sisters(self) -> Ship:
        """The ship file with what the class has in common."""
    @property
    def spread(self) -> float:
        """Of coefficients between vessels, over their confidence."""
    @property
    def trace(self) -> List[str]:
        """Changes too small to matter, in words."""
    @property
    def troubles(self) -> List[str]: ...
    @property
    def vessels(self) -> List[VesselReport]:
        """Worst first."""
    @property
    def words(self) -> str: ...

class FleetErrors:
    """Errors of replays over the variation of what was recorded."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> FleetErrors: ...
    @property
    def given(self) -> float:
        """By the ship file."""
    @property
    def own(self) -> float:
        """With what the vessel has of her own, and its changes."""
    @property
    def sisters(self) -> float:
        """With what the class has in common."""

class FleetRun:
    """A recording and the ship that made it."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> FleetRun: ...
    def __init__(self, vessel: str = ..., run: Recording = ...) -> None: ...
    @property
    def run(self) -> Recording:
        """Must tell when it was, by its key start_utc."""
    @property
    def vessel(self) -> str:
        """Her name."""

class ForceBreakdown:
    """Forces about midship, split by part, and what they do to the ship."""
    @property
    def acceleration(self) -> PlanarAcceleration:
        """Of midship in body axes."""
    @property
    def parts(self) -> dict:
        """hull, propeller, rudder, …, wind where there is some, and effects by their names: PlanarForce."""
    @property
    def total(self) -> PlanarForce:
        """Drives the equations of motion of the model."""

class ForceBudget:
    """The force that the given ship lacks, split by what it follows."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ForceBudget: ...
    @property
    def quantity(self) -> str:
        """surge_force, sway_force or yaw_moment."""
    @property
    def share(self) -> List[float]:
        """Of its mean square; they add up to 1. `shares` has the names."""
    @property
    def shares(self) -> dict:
        """By form, form_asymmetric, earth_fixed, delayed, instruments, unexplained."""
    @property
    def size(self) -> float:
        """Its mean square over that of the force on the ship's own hull."""
    @property
    def standard_error(self) -> List[float]:
        """In the same order."""
    @property
    def standard_errors(self) -> dict: ...

class ForceEquation:
    """One of the three force equations and the coefficients in it."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ForceEquation: ...
    @property
    def R2(self) -> float:
        """Share of the variance explained."""
    @property
    def bias(self) -> numpy.ndarray:
        """How far errors of the estimated motion may have moved each coefficient."""
    @property
    def coefficients(self) -> List[Coefficient]: ...
    @property
    def component(self) -> str:
        """X, Y or N."""
    @property
    def condition_number(self) -> float: ...
    @property
    def fit(self) -> Regression:
        """Of forces over ½ρL²U², moments over ½ρL³U²."""
    @property
    def residual_rms(self) -> float: ...
    @property
    def samples(self) -> float:
        """Effective number."""
    @property
    def undetermined(self) -> List[str]:
        """Sums that the data do not determine, worst first: "Y_v - 0.98 Y_r"."""

class ForceFit:
    """Coefficients of a ship from the forces that recorded ships must have felt."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ForceFit: ...
    def _repr_html_(self) -> str: ...
    @property
    def coefficients(self) -> dict:
        """Of all equations, by name."""
    @property
    def equations(self) -> List[ForceEquation]:
        """Those that have a coefficient to be found."""
    @property
    def range(self) -> MotionRange:
        """Of the motions."""
    @property
    def ship(self) -> Ship:
        """With the coefficients found."""
    @property
    def stability(self) -> StabilityVerdict:
        """Whether the fitted ship keeps a straight course."""
    @property
    def states(self) -> List[StateEstimate]:
        """Of each run."""

class FoundEffect:
    """An effect that the recordings show."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> FoundEffect: ...
    @property
    def depends_on(self) -> str:
        """Of what has no name, what it goes with, in words."""
    @property
    def effect(self) -> Effect:
        """In the mean of the runs, where it differs."""
    @property
    def end(self) -> Optional[float]:
        """[s]"""
    @property
    def indistinguishable_from(self) -> List[str]:
        """Effects that explain the runs as well."""
    @property
    def onset(self) -> Optional[float]:
        """[s]"""
    @property
    def parameters(self) -> List[ParameterEstimate]:
        """With standard errors."""
    @property
    def probability(self) -> float: ...
    @property
    def scope(self) -> str:
        """That it differs with: ship where it is the same in all."""

class GroupCheck:
    """What the runs of a group have in common."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> GroupCheck: ...
    @property
    def errors(self) -> List[InstrumentError]:
        """Pooled."""
    @property
    def group(self) -> str:
        """Its name."""
    @property
    def runs(self) -> List[str]:
        """Their names."""

class HeldYawRate:
    """A yaw rate and the rudder that holds it."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> HeldYawRate: ...
    @property
    def r(self) -> float:
        """[rad/s]"""
    @property
    def turn(self) -> Optional[SteadyTurn]:
        """None where no rudder angle up to the largest holds it."""

class ImoCriteria:
    """Steering criteria of MSC.137(76), section 5.3, to both sides."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ImoCriteria: ...
    def _repr_html_(self) -> str: ...
    @property
    def criteria(self) -> List[Criterion]:
        """First of manoeuvres to starboard, then to port."""
    @property
    def length(self) -> float:
        """[m]"""
    @property
    def propulsion(self) -> Controls:
        """Held during the manoeuvres."""
    @property
    def speed(self) -> float:
        """Test speed [m/s]."""
    def to_dataframe(self) -> Any:
        """The criteria as a pandas.DataFrame: criterion, first to, value, limit, unit, passed."""

class ImoSummary:
    """The criteria of several trials together."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ImoSummary: ...
    @property
    def any(self) -> bool:
        """Whether anything was judged."""
    @property
    def cannot_tell(self) -> List[str]:
        """The value crosses the limit, or was not reached."""
    @property
    def failed(self) -> List[str]:
        """\"tactical_diameter to port\""""
    @property
    def not_told(self) -> List[str]:
        """No run tells it on either side."""

class Import:
    """A raw file as a recording file."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Import: ...
    @property
    def columns(self) -> List[ImportedColumn]:
        """What each column was taken for."""
    @property
    def notes(self) -> List[str]:
        """Facts of the whole file, one line each: encoding, clock, zone, what was dropped."""
    @property
    def text(self) -> str:
        """The recording file, which parse_csv reads."""

class ImportedColumn:
    """What one column of a raw file was taken for."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ImportedColumn: ...
    @property
    def samples(self) -> int:
        """With a value."""
    @property
    def source(self) -> str:
        """As the file names it: "Kurs [°]", "HDT"."""
    @property
    def taken_for(self) -> str:
        """Column of the recording, "psi_deg"; empty where it was left out."""
    @property
    def why(self) -> str:
        """By name, unit, values: plain words."""

class IndexCombination:
    """A combination of relative changes of the numbers that the indices see as one."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> IndexCombination: ...
    @property
    def determined(self) -> bool:
        """To better than a half, so that its sign is known."""
    @property
    def singular_value(self) -> float:
        """Of the Jacobian over the tolerances."""
    @property
    def standard_error(self) -> float:
        """Relative, from the indices alone."""
    @property
    def weights(self) -> numpy.ndarray:
        """Of the numbers; their squares add up to 1."""

class IndexEstimates:
    """Fitted steering indices, dimensionless."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> IndexEstimates: ...
    @property
    def Kb(self) -> Estimate: ...
    @property
    def Kw(self) -> Estimate: ...
    @property
    def T1T2(self) -> Estimate: ...
    @property
    def T1_plus_T2(self) -> Estimate: ...
    @property
    def T3b(self) -> Estimate: ...
    @property
    def T3w(self) -> Estimate: ...

class IndexSensitivity:
    """What numbers of a ship do to her indices: a row for each index, a column for each number; NaN where an index does not exist."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> IndexSensitivity: ...
    @property
    def exact(self) -> numpy.ndarray:
        """d ln index / d ln number."""
    @property
    def indices(self) -> numpy.ndarray:
        """Of the ship, SI, in the order of the file."""
    @property
    def simulations(self) -> SimulationCount:
        """That it took."""
    @property
    def ten_per_cent(self) -> numpy.ndarray:
        """Relative change for 10 % more of the number."""

class InstabilityLoop:
    """Hysteresis of an unstable ship."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> InstabilityLoop: ...
    @property
    def height(self) -> float:
        """Between the stable yaw rates at the neutral rudder angle [rad/s]."""
    @property
    def width(self) -> float:
        """Of rudder angle between the folds of the curve [rad]."""

class InstrumentError:
    """One error of one channel of a run."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> InstrumentError: ...
    @property
    def at(self) -> float:
        """Of a jump, on the run's clock [s]."""
    @property
    def at_standard_error(self) -> float:
        """[s]"""
    @property
    def channel(self) -> str:
        """By its short name."""
    @property
    def is_mistake(self) -> bool:
        """No number of the run can be believed before it is mended: sign, unit, order."""
    @property
    def kind(self) -> str:
        """unit, sign, order, zero, scale, delay, clock, clock_rate, jump, smoothing, axes, lever_arm_x or lever_arm_y."""
    @property
    def readings(self) -> List[str]:
        """What a lateness may be, where several things look alike."""
    @property
    def remedy(self) -> str:
        """What mends a mistake; empty for others."""
    @property
    def standard_error(self) -> float:
        """In `unit`."""
    @property
    def told(self) -> bool:
        """Larger than what chance makes of none, and than what matters."""
    @property
    def unit(self) -> str:
        """\"s", "rad", "rad/s", "m", "m/s" or ""."""
    @property
    def value(self) -> float:
        """In `unit`; docs/check.md tells the meaning by kind."""
    @property
    def words(self) -> str:
        """\"yaw rate: zero 0.031 ± 0.002 deg/s\""""

class InstrumentEstimate:
    """An error of an instrument found beside everything else."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> InstrumentEstimate: ...
    @property
    def channel(self) -> str:
        """\"r", "x" for both coordinates of a position."""
    @property
    def error(self) -> str:
        """zero, scale, delay, axes, lever_arm_x or lever_arm_y."""
    @property
    def is_effect(self) -> bool:
        """Large enough to stand among the effects, too."""
    @property
    def standard_error(self) -> float:
        """In `unit`."""
    @property
    def unit(self) -> str: ...
    @property
    def value(self) -> float:
        """In `unit`."""

class InverseDynamics:
    """Forces that a recorded ship must have felt at one sample."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> InverseDynamics: ...
    @property
    def damping(self) -> EstimatedForce:
        """Of the water: hull, propeller, rudder and what the model lacks."""
    @property
    def hull(self) -> EstimatedForce:
        """The same without what the model says of propeller and rudder."""
    @property
    def time(self) -> float:
        """[s]"""

class JudgedCriterion:
    """A criterion of MSC.137(76) on a recorded number."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> JudgedCriterion: ...
    @property
    def limit(self) -> float:
        """In `unit`."""
    @property
    def name(self) -> str:
        """\"tactical_diameter\""""
    @property
    def passed(self) -> Optional[bool]:
        """None where value ± 2 standard errors holds the limit."""
    @property
    def side(self) -> str:
        """Turned to first."""
    @property
    def unit(self) -> str:
        """\"L" or "deg"."""
    @property
    def value(self) -> Optional[Told]:
        """In `unit`."""

class Leg:
    """Motion under a rudder that moves in one straight line."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Leg: ...
    @property
    def begin(self) -> float:
        """s' at its start."""
    @property
    def end(self) -> str:
        """What ends it: limit, arrival of the rudder, heading, peak."""
    @property
    def length(self) -> float:
        """Ship lengths until its end."""
    @property
    def rudder(self) -> RudderLine:
        """Its rudder."""
    @property
    def start(self) -> LinearState:
        """State there."""

class LimitCycle:
    """A zigzag sailed until each reversal repeats the one before."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LimitCycle: ...
    @property
    def settled(self) -> bool:
        """Whether it repeats to 1e-12."""
    @property
    def zigzag(self) -> LinearZigzag:
        """As sailed."""

class LinearAmplitude:
    """Largest motions among the samples used."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearAmplitude: ...
    @property
    def drift(self) -> float:
        """[rad]; NaN without drift."""
    @property
    def omega(self) -> float:
        """rL/U"""
    @property
    def rudder(self) -> float:
        """[rad]"""

class LinearFit:
    """The linear sway–yaw equations that explain recordings.
    
    Where drift was not recorded, only the transfer function of yaw and its indices are determined."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearFit: ...
    @property
    def amplitude(self) -> LinearAmplitude:
        """A verdict on stability holds for motions of this size."""
    @property
    def best_combination(self) -> str:
        """Which product of powers is known best."""
    @property
    def coefficients(self) -> CoefficientEstimates:
        """Of the coupled equations."""
    @property
    def condition_number(self) -> float:
        """Of combinations of the constants."""
    @property
    def covariance(self) -> numpy.ndarray:
        """Of a1, b1, c1, a2, b2, c2; NaN without drift."""
    @property
    def disturbance(self) -> Disturbance:
        """Estimated."""
    @property
    def drift_offset(self) -> Estimate:
        """Recorded minus true [rad]."""
    @property
    def indices(self) -> IndexEstimates: ...
    @property
    def noise(self) -> ChannelNoise:
        """Known or estimated."""
    @property
    def one_step(self) -> LinearResiduals:
        """From one measurement to the next."""
    @property
    def probability_stable(self) -> float:
        """At least; errors taken as normal."""
    @property
    def rudder_offset(self) -> Estimate:
        """Recorded angle plus this acts [rad]."""
    @property
    def samples(self) -> int:
        """With a measurement that is used."""
    @property
    def scale(self) -> PrimeScale:
        """Length and mean speed."""
    @property
    def stable(self) -> bool:
        """At the estimate."""
    @property
    def starts(self) -> List[LinearStateEstimates]:
        """State at the first sample used, of each run."""
    @property
    def status(self) -> str:
        """converged, iteration limit or rank deficient."""
    @property
    def time_constants(self) -> Optional[TimeConstantEstimates]:
        """None when they are a complex pair."""
    @property
    def transfer(self) -> TransferEstimates:
        """Of drift and yaw."""
    @property
    def whole_run(self) -> LinearResiduals:
        """Of the simulation of the whole run."""
    @property
    def worst_combination(self) -> str:
        """And which worst."""
    @property
    def yaw_rate_offset(self) -> Estimate:
        """Recorded minus true [rad/s]."""

class LinearHull:
    """Hull of a ship in linear motion, dimensionless. Source: [Artyszuk2016] eqs (2)–(14)"""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearHull: ...
    @property
    def L_over_B(self) -> float:
        """Length over beam."""
    @property
    def N_b(self) -> float:
        """Yaw moment by drift, per degree, ½ρL²TV²."""
    @property
    def N_w(self) -> float:
        """Yaw moment by omega', ½ρL²TV²."""
    @property
    def Y_b(self) -> float:
        """Sway force by drift, per degree, ½ρLTV²."""
    @property
    def Y_w(self) -> float:
        """Sway force by omega', ½ρLTV²."""
    def __init__(self, L_over_B: float = ..., c_B: float = ..., k_11: float = ..., k_22: float = ..., r_z: float = ..., r_66: float = ..., Y_b: float = ..., Y_w: float = ..., N_b: float = ..., N_w: float = ...) -> None: ...
    @property
    def c_B(self) -> float:
        """Block coefficient."""
    @property
    def k_11(self) -> float:
        """Surge added mass over mass."""
    @property
    def k_22(self) -> float:
        """Sway added mass over mass."""
    @property
    def r_66(self) -> float:
        """Added radius of gyration over length."""
    @property
    def r_z(self) -> float:
        """Radius of gyration over length."""

class LinearParts:
    """A ship in linear motion, as hull and rudder."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearParts: ...
    def __init__(self, hull: LinearHull = ..., rudder: LinearRudder = ...) -> None: ...
    @property
    def hull(self) -> LinearHull:
        """Hull."""
    @property
    def rudder(self) -> LinearRudder:
        """Rudder."""

class LinearResiduals:
    """Rms of what the fit leaves unexplained; NaN for a channel not used."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearResiduals: ...
    @property
    def beta(self) -> float:
        """[rad]"""
    @property
    def psi(self) -> float:
        """[rad]"""
    @property
    def r(self) -> float:
        """[rad/s]"""

class LinearReversal:
    """A rudder reversal and the heading peak that follows it."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearReversal: ...
    @property
    def execute(self) -> float:
        """s' at which the heading reaches H."""
    @property
    def leg(self) -> int:
        """First leg after the reversal."""
    @property
    def overshoot(self) -> float:
        """Heading beyond H at the peak [rad]."""
    @property
    def peak(self) -> float:
        """s' at which the yaw rate passes zero."""

class LinearRudder:
    """Rudder of a ship in linear motion, dimensionless."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearRudder: ...
    def __init__(self, area_ratio: float = ..., w: float = ..., c_Th: float = ..., lift_slope: float = ..., a_H: float = ..., c_Ry: float = ..., x_Reff: float = ...) -> None: ...
    @property
    def a_H(self) -> float:
        """Hull's share of the rudder force."""
    @property
    def area_ratio(self) -> float:
        """A_R/(LT)"""
    @property
    def c_Ry(self) -> float:
        """Effective over geometric drift angle at the rudder."""
    @property
    def c_Th(self) -> float:
        """Thrust loading 8 K_T/(π J²)."""
    @property
    def lift_slope(self) -> float:
        """d(c_L)/d(alpha) on the race speed, per degree."""
    @property
    def w(self) -> float:
        """Wake fraction."""
    @property
    def x_Reff(self) -> float:
        """Where the rudder force acts, forward of midship over length."""

class LinearShip:
    """A ship in linear motion."""
    def __init__(self: LinearShip, name: str, length: float, service_speed: float, form: Union[LinearParts, SwayYawCoefficients, SteeringIndices], steering_gear: Optional[SteeringGear] = ...) -> None:
        """Length [m], service speed [m/s], and LinearParts, SwayYawCoefficients or SteeringIndices. The steering gear turns by 2.3 deg/s up to 35 deg unless given."""
    @property
    def coefficients(self) -> SwayYawCoefficients:
        """Of the coupled equations. Raises Refusal where there are none."""
    @property
    def form(self) -> Any:
        """LinearParts, SwayYawCoefficients or SteeringIndices."""
    @property
    def indices(self) -> SteeringIndices:
        """Steering indices."""
    @property
    def length(self) -> float:
        """[m]"""
    @property
    def name(self) -> str: ...
    @name.setter
    def name(self, value: Any) -> None: ...
    def save(self: LinearShip, file: Union[str, 'PathLike[str]'], remark: str = ...) -> None:
        """Writes her ship file, whole or not at all."""
    def scale(self: LinearShip, speed: float) -> PrimeScale:
        """Length of the ship and a speed [m/s]."""
    @property
    def service_speed(self) -> float:
        """[m/s]"""
    @property
    def steering_gear(self) -> SteeringGear: ...
    def text(self: LinearShip, remark: str = ...) -> str:
        """The text of her ship file."""
    @property
    def transfer_functions(self) -> SwayYawTransfer:
        """Every linear ship has them."""

class LinearState:
    """Drift, yaw rate and heading of a ship in linear motion."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearState: ...
    def __init__(self, beta: float = ..., omega: float = ..., psi: float = ...) -> None: ...
    @property
    def beta(self) -> float:
        """Drift angle [rad]."""
    @property
    def omega(self) -> float:
        """omega' = rL/U."""
    @property
    def psi(self) -> float:
        """Heading [rad]."""

class LinearStateEstimates:
    """A fitted state."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearStateEstimates: ...
    @property
    def beta(self) -> Estimate:
        """[rad]"""
    @property
    def omega(self) -> Estimate:
        """rL/U"""
    @property
    def psi(self) -> Estimate:
        """[rad]"""

class LinearView:
    """A recorded zigzag and the refitted ship's, by K, T and the loop."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearView: ...
    @property
    def amplitude(self) -> float:
        """Largest rudder angle [rad]."""
    @property
    def model(self) -> ZigzagView: ...
    @property
    def recorded(self) -> ZigzagView: ...
    @property
    def run(self) -> str:
        """Its name."""

class LinearZigzag:
    """An exact zigzag of a ship in linear motion."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearZigzag: ...
    @property
    def legs(self) -> List[Leg]:
        """Each in closed form."""
    @property
    def period(self) -> Optional[float]:
        """From the last reversal but two to the last [ship lengths]."""
    def recording(self: LinearZigzag, coefficients: SwayYawCoefficients, scale: PrimeScale, step: float) -> Recording:
        """As a recording with samples every `step` [s]."""
    @property
    def reversals(self) -> List[LinearReversal]:
        """In their order."""
    def rudder(self: LinearZigzag, s: ArrayLike) -> numpy.ndarray:
        """Rudder angle at times s' [rad]."""
    def states(self: LinearZigzag, coefficients: SwayYawCoefficients, s: ArrayLike) -> dict:
        """Exact states of its ship at times s': beta, omega, psi."""

class LinearZigzagBatch:
    """Zigzags of many linear ships: reversals by ships; NaN for what a ship did not reach."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LinearZigzagBatch: ...
    @property
    def by_numbers(self) -> int:
        """Ships that the packs left to the scalar code."""
    @property
    def count(self) -> numpy.ndarray:
        """Reversals of each ship."""
    @property
    def execute(self) -> numpy.ndarray:
        """s' at which the heading reaches H."""
    @property
    def overshoot(self) -> numpy.ndarray:
        """Heading beyond H at the peak [rad]."""
    @property
    def peak(self) -> numpy.ndarray:
        """s' at which the yaw rate passes zero."""
    @property
    def reversals(self) -> int:
        """Asked for."""
    @property
    def ships(self) -> int:
        """How many."""

class Linearization:
    """Small motions about a steady one, by exact derivatives of the forces, SI:
    
    d(x)/dt = A x + B delta,   x = (u, v, r) less that of the operating point"""
    @property
    def A(self) -> numpy.ndarray:
        """Derivatives of du/dt, dv/dt, dr/dt by u, v, r: numpy.ndarray, 3 by 3."""
    @property
    def B(self) -> numpy.ndarray:
        """By the rudder angle, positive to port: numpy.ndarray, 3 by 1."""
    inputs: Tuple[str, ...]
    @property
    def parts(self) -> dict:
        """A and B of hull, propeller, rudder, …, centrifugal; they add up to the whole."""
    @property
    def point(self) -> OperatingPoint: ...
    @property
    def poles(self) -> List[complex]:
        """Of u, v and r together [1/s]."""
    @property
    def scale(self) -> PrimeScale:
        """Length, and speed of the operating point."""
    @property
    def sname(self) -> SnameDerivatives:
        """Sway and yaw derivatives in ½ρL²U² and ½ρL³U², with the masses of the ship."""
    def state_space(self, heading: bool = ...) -> StateSpace:
        """The linear model with the states u, v, r as outputs, and psi where `heading` asks for it: d(psi)/dt = r."""
    states: Tuple[str, ...]
    @property
    def sway_yaw(self) -> SwayYawCoefficients:
        """Coupled equations of drift and yaw at constant speed, SwayYawCoefficients."""

class LoopMeasures:
    """Measures of the drift–yaw loop of a zigzag."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LoopMeasures: ...
    @property
    def area(self) -> float:
        """|∮ beta d(omega')| [rad]."""
    @property
    def beta_at_omega_zero(self) -> float:
        """|beta| where omega' passes zero [rad]."""
    @property
    def beta_max(self) -> float:
        """Largest |beta| [rad]."""
    @property
    def distance_from_line(self) -> float:
        """Root mean square from omega' = (Kw/Kb) beta."""
    @property
    def inclination(self) -> float:
        """Of the long axis from the beta axis towards omega' [rad]."""
    @property
    def length(self) -> float:
        """Long axis."""
    @property
    def omega_at_beta_zero(self) -> float:
        """|omega'| where beta passes zero."""
    @property
    def omega_max(self) -> float:
        """Largest |omega'|."""
    @property
    def width(self) -> float:
        """Short axis."""

class LoopSensitivity:
    """Loop and overshoots with exact derivatives by T3b and T3w."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> LoopSensitivity: ...
    @property
    def by_T3b(self) -> LoopMeasures:
        """Its derivatives by T3b, the other indices held."""
    @property
    def by_T3w(self) -> LoopMeasures:
        """By T3w."""
    @property
    def overshoot(self) -> numpy.ndarray:
        """[rad], one for each reversal."""
    @property
    def overshoot_by_T3b(self) -> numpy.ndarray:
        """Its derivatives."""
    @property
    def overshoot_by_T3w(self) -> numpy.ndarray:
        """Its derivatives."""
    @property
    def period(self) -> float:
        """[ship lengths]"""
    @property
    def period_by_T3b(self) -> float:
        """Its derivative."""
    @property
    def period_by_T3w(self) -> float:
        """Its derivative."""
    @property
    def settled(self) -> bool:
        """The loop is the limit cycle."""
    @property
    def value(self) -> LoopMeasures:
        """The loop."""

class ManoeuvrePiece:
    """A stretch of a recording in which one manoeuvre is sailed."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ManoeuvrePiece: ...
    @property
    def begin(self) -> float:
        """[s], time of the recording."""
    @property
    def end(self) -> float:
        """[s]"""
    @property
    def execute(self) -> Optional[float]:
        """First rudder order [s]; None for steady runs."""
    @property
    def manoeuvre(self) -> str:
        """\"zigzag 10/10", "turn 35", "spiral 25", "steady run" …"""
    @property
    def why(self) -> str:
        """How it was recognised, one line."""

class MapFit:
    """The most probable values of unknowns."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> MapFit: ...
    @property
    def covariance(self) -> numpy.ndarray:
        """Of the point."""
    @property
    def information(self) -> numpy.ndarray:
        """Of the runs alone."""
    @property
    def log_evidence(self) -> float:
        """By Laplace; differences are what counts."""
    @property
    def noise(self) -> Noise:
        """That suits it best."""
    @property
    def point(self) -> numpy.ndarray:
        """In the order of the unknowns."""

class MeasuredIndex:
    """One measured number of a manoeuvre, SI."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> MeasuredIndex: ...
    @property
    def deviation(self) -> float:
        """Standard deviation."""
    @property
    def name(self) -> str:
        """As in the file: "advance_L", "overshoot_deg 2" for the second peak."""
    @property
    def place(self) -> int:
        """Among the indices of such a manoeuvre."""
    @property
    def si(self) -> float:
        """SI value of one unit of the file."""
    @property
    def value(self) -> float:
        """Of a turn to port that of its mirror image."""

class MeasuredIndices:
    """Indices of manoeuvres that were measured, and how they were sailed."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> MeasuredIndices: ...
    @property
    def rev(self) -> Optional[float]:
        """Shaft speed [1/s]; None for that of self-propulsion."""
    @property
    def speed(self) -> Optional[float]:
        """Of the approach [m/s]; None for the service speed."""
    @property
    def thrust(self) -> Optional[float]:
        """Of all propellers, in place of a shaft speed [N]."""
    @property
    def trials(self) -> List[MeasuredTrial]:
        """Turns first."""

class MeasuredTrial:
    """A manoeuvre and its measured indices."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> MeasuredTrial: ...
    @property
    def indices(self) -> List[MeasuredIndex]:
        """In the order of the file."""
    @property
    def manoeuvre(self) -> Union[TurnOrder, ZigzagOrder]:
        """That was sailed."""
    @property
    def name(self) -> str:
        """\"turn 35 to starboard\""""

class MismatchPlace:
    """Where force is missing in a run."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> MismatchPlace: ...
    @property
    def begin(self) -> float:
        """[s]"""
    @property
    def end(self) -> float:
        """[s]"""
    @property
    def quantity(self) -> str:
        """surge_force, sway_force or yaw_moment."""
    @property
    def run(self) -> str:
        """Its name."""
    @property
    def share(self) -> float:
        """Of all unexplained force of that kind."""
    @property
    def where(self) -> str:
        """In words."""

class MissingForce:
    """What drives a ship beyond her model at a time, given the whole run."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> MissingForce: ...
    @property
    def acceleration(self) -> PlanarAcceleration:
        """[m/s², m/s², rad/s²]"""
    @property
    def acceleration_deviation(self) -> PlanarAcceleration:
        """Standard deviation."""
    @property
    def force(self) -> PlanarForce:
        """That accelerates ship and entrained water so [N, N, N m]."""
    @property
    def force_deviation(self) -> PlanarForce:
        """Standard deviation."""
    @property
    def motion(self) -> PlanarMotion:
        """Through the water, as estimated along with it."""

class MotionRange:
    """Largest motions in recordings; what is said holds for motions of this size."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> MotionRange: ...
    @property
    def drift(self) -> float:
        """[rad]"""
    @property
    def omega(self) -> float:
        """|r'|"""
    @property
    def rudder(self) -> float:
        """[rad]"""

class MovedPart:
    """The part of the ship whose coefficients, moved alone, bring her nearest."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> MovedPart: ...
    @property
    def discrepancy(self) -> float:
        """Error of the yaw rate then, over its variation."""
    @property
    def most(self) -> List[BaselineShift]:
        """Its coefficients that moved most."""
    @property
    def part(self) -> str:
        """\"rudder\""""
    @property
    def rudder_force(self) -> Optional[float]:
        """Of a rudder: its moment over that as given."""

class Noise:
    """What no model and no instrument gets right."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Noise: ...
    def __init__(self, scale: float = ..., apart: bool = ..., axes: List[float] = ..., memory: float = ..., with_memory: bool = ..., walk: float = ..., factor: List[float] = ...) -> None: ...
    @property
    def apart(self) -> bool:
        """Each axis has a scale, and the noise a memory of its own."""
    @property
    def axes(self) -> List[float]:
        """Factors on the scale in surge, sway and yaw."""
    @property
    def factor(self) -> List[float]:
        """On the noise of each channel, in the order of `channels()`."""
    @property
    def memory(self) -> float:
        """Of the process noise, over L/U."""
    @property
    def scale(self) -> float:
        """Of the ordinary process noise."""
    @property
    def walk(self) -> float:
        """What the error of a position wanders in L/U, over L."""
    @property
    def with_memory(self) -> bool:
        """Errors of positions have one, as receivers have it."""

class NoiseEstimate:
    """Noise that makes recorded runs most likely."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> NoiseEstimate: ...
    @property
    def converged(self) -> bool:
        """True where nothing had to be estimated."""
    @property
    def iterations(self) -> int:
        """Of the estimation of the noise."""
    @property
    def log_likelihood(self) -> float:
        """Of all runs."""
    @property
    def noise(self) -> dict:
        """Standard deviation by channel, known or estimated, SI."""
    @property
    def process_noise(self) -> PlanarAcceleration:
        """Size of the unmodelled accelerations."""

class NomotoTold:
    """T dr/dt + r = K (delta + offset), delta positive to STARBOARD, as K is read:
    positive for a stable ship."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> NomotoTold: ...
    @property
    def K(self) -> Told:
        """[1/s]"""
    @property
    def T(self) -> Told:
        """[s]"""
    @property
    def heading(self) -> numpy.ndarray:
        """Fitted, off the approach [rad]."""
    @property
    def offset(self) -> Told:
        """Acts beside the recorded angle, positive to starboard [rad]."""
    @property
    def residual(self) -> float:
        """Rms of the heading left unexplained [rad]."""
    @property
    def time(self) -> numpy.ndarray:
        """Of the fitted heading [s]."""

class NomotoZigzag:
    """First-order equation T dr/dt + r = K (delta + delta_r), rudder to port."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> NomotoZigzag: ...
    @property
    def K(self) -> float:
        """[1/s], negative for a stable ship."""
    @property
    def T(self) -> float:
        """[s]"""
    @property
    def delta_r(self) -> float:
        """Rudder offset [rad]."""
    @property
    def intervals(self) -> int:
        """Used."""
    @property
    def residual(self) -> float:
        """Rms of the heading changes left unexplained [rad]."""

class OperatingPoint:
    """A motion and the controls that keep it."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> OperatingPoint: ...
    def __init__(self, motion: PlanarMotion = ..., controls: Controls = ...) -> None: ...
    @property
    def controls(self) -> Controls:
        """Rudder and propulsion."""
    @property
    def motion(self) -> PlanarMotion:
        """Through the water."""

class Parameter:
    """A number of a ship or of an effect: value, unit, range, and what is known of it."""
    def __float__(self: Parameter) -> float: ...
    @property
    def deviation(self) -> float:
        """Standard deviation before any recording, in `unit`; 0 for a fact."""
    @property
    def name(self) -> str:
        """Key of the ship file, with its table where two have it."""
    @property
    def null(self) -> float:
        """Mean before any recording, in `unit`: of an effect where it does nothing."""
    @property
    def range(self) -> Tuple[float, float]:
        """Lowest and highest value that a ship file accepts, in `unit`."""
    @property
    def role(self) -> str:
        """\"coefficient" if it can be fitted, "fact" if not."""
    @property
    def scope(self) -> str:
        """Whose it is: "ship", "group" of runs or "run"."""
    @property
    def table(self) -> str:
        """Of the ship file; of an effect its id."""
    @property
    def unit(self) -> str:
        """As in ship files, "-" for none."""
    @property
    def value(self) -> float:
        """In `unit`."""
    @property
    def value_si(self) -> float:
        """In SI."""

class ParameterEstimate:
    """A parameter of an effect with its standard error."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ParameterEstimate: ...
    @property
    def key(self) -> str:
        """Of ship files, unit in the name."""
    @property
    def standard_error(self) -> float:
        """In that unit."""
    @property
    def value(self) -> float:
        """In that unit."""

class PlanarAcceleration:
    """Time derivative of a planar motion in body axes."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> PlanarAcceleration: ...
    def __init__(self, u: float = ..., v: float = ..., r: float = ...) -> None: ...
    @property
    def r(self) -> float:
        """dr/dt [rad/s²]."""
    @property
    def u(self) -> float:
        """du/dt [m/s²]."""
    @property
    def v(self) -> float:
        """dv/dt [m/s²]."""

class PlanarForce:
    """Force in body axes and moment about midship."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> PlanarForce: ...
    @property
    def N(self) -> float:
        """Yaw moment about midship, positive to starboard [N m]."""
    @property
    def X(self) -> float:
        """Surge force [N]."""
    @property
    def Y(self) -> float:
        """Sway force, positive to starboard [N]."""
    def __init__(self, X: float = ..., Y: float = ..., N: float = ...) -> None: ...

class PlanarMotion:
    """Velocity of midship in body axes, and yaw rate."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> PlanarMotion: ...
    def __init__(self, u: float = ..., v: float = ..., r: float = ...) -> None: ...
    @property
    def r(self) -> float:
        """Yaw rate, positive to starboard [rad/s]."""
    @property
    def u(self) -> float:
        """Surge [m/s]."""
    @property
    def v(self) -> float:
        """Sway, positive to starboard [m/s]."""

class PrimeScale:
    """Length and speed that make quantities dimensionless: s' = tU/L, omega' = rL/U."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> PrimeScale: ...
    @property
    def L(self) -> float:
        """[m]"""
    @property
    def U(self) -> float:
        """[m/s]"""
    def __init__(self, L: float = ..., U: float = ...) -> None: ...

class PullOut:
    """What is left of a turn once the rudder is amidships."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> PullOut: ...
    def _repr_html_(self) -> str: ...
    @property
    def approach_speed(self) -> float:
        """[m/s]"""
    @property
    def propulsion(self) -> Controls:
        """Held during the manoeuvre."""
    @property
    def sides(self) -> PullOutSides:
        """By the side of the turn."""

class PullOutSide:
    """Pull-out from a turn to one side."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> PullOutSide: ...
    @property
    def T1(self) -> Optional[float]:
        """Slower time constant of sway and yaw about the steady motion [s]."""
    @property
    def decay_time(self) -> Optional[float]:
        """T of exp(-t/T) at the end [s]."""
    @property
    def execute(self) -> float:
        """When the rudder is ordered amidships [s]."""
    @property
    def fall_time(self) -> Optional[float]:
        """From the order until 1/e of the change of yaw rate is left [s]."""
    @property
    def residual(self) -> float:
        """Yaw rate at the end [rad/s]: 0 for a course-stable ship."""
    @property
    def run(self) -> Recording:
        """The time series."""
    @property
    def settled(self) -> bool:
        """The end was steady."""
    @property
    def turning(self) -> float:
        """Yaw rate then [rad/s]."""
    @property
    def turning_settled(self) -> bool:
        """The turn was steady."""

class PullOutSides:
    """By the side of the turn."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> PullOutSides: ...
    @property
    def port(self) -> PullOutSide:
        """From a turn to port."""
    @property
    def starboard(self) -> PullOutSide:
        """From a turn to starboard."""

class QuantityError:
    """Simulated minus recorded, in the SI unit of the quantity."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> QuantityError: ...
    @property
    def beyond_noise(self) -> float:
        """sqrt(max(0, window_rms² - noise²))."""
    @property
    def bias(self) -> float:
        """Mean error, restarted every window."""
    @property
    def is_in_waves(self) -> bool:
        """Whether waves add as much to the recording as the window error is."""
    @property
    def noise(self) -> float:
        """Scatter of the samples about local parabolas."""
    @property
    def normalised(self) -> float:
        """window_rms over variation."""
    @property
    def normalised_beyond_waves(self) -> float:
        """sqrt(max(0, window_rms² - waves²)) over variation."""
    @property
    def open_loop_normalised(self) -> float: ...
    @property
    def open_loop_rms(self) -> float:
        """Never restarted."""
    @property
    def quantity(self) -> str:
        """heading, yaw_rate, speed, drift or position."""
    @property
    def region(self) -> Optional[RegionError]:
        """The worst of them."""
    @property
    def regions(self) -> List[RegionError]:
        """By drift, yaw rate and rudder."""
    @property
    def variation(self) -> float:
        """Root-mean-square variation of the recorded quantity."""
    @property
    def waves(self) -> float:
        """What waves add to the recorded quantity, root mean square."""
    @property
    def window_rms(self) -> float:
        """Restarted every window."""
    @property
    def worst(self) -> Optional[WorstInterval]:
        """Where most of it is."""

class Recording:
    """Samples of a ship in motion, recorded at sea, in a tank or by a simulation.
    
    SI, radians, rudder positive to port, position and velocity of midship, heading unwrapped. Time increases strictly;
    sampling may be irregular; a missing sample is NaN.
    
    `run["psi_rad"]` is a numpy array on the samples themselves, and writing to it changes them; `run["psi_deg"]` is a copy in
    another unit. `channels()` lists all columns."""
    def __contains__(self: Recording, column: str) -> bool:
        """Whether the quantity of that column was recorded."""
    def __getitem__(self: Any, column: str) -> Any:
        """Samples of a column, in its unit; KeyError if not recorded."""
    def __init__(self: Recording, time: ArrayLike, columns: dict, *, name: str = ..., rudder_positive: str = ..., manoeuvre: str = ..., execute: Optional[float] = ..., water_depth: Optional[float] = ...) -> None:
        """From arrays by column, "psi_rad" or "psi_deg", copied once into SI; time in seconds.
        
        rudder_positive: side to which the given rudder angles are positive. execute: time of the first rudder order [s].
        water_depth [m]. Raises ValueError unless time increases and all columns are as long."""
    def __iter__(self: Recording) -> Iterator: ...
    def __len__(self: Recording) -> int: ...
    def __setitem__(self: Recording, column: str, values: ArrayLike) -> None:
        """Sets the samples of a column given in its unit, NaN where missing."""
    @property
    def columns(self) -> List[str]:
        """Names of the SI columns that were recorded."""
    def csv_text(self: Recording) -> str:
        """The text of a recording file: SI columns, full precision."""
    @property
    def execute(self) -> Optional[float]:
        """Time of the first rudder order [s]."""
    @execute.setter
    def execute(self, value: Any) -> None: ...
    @property
    def extra(self) -> dict:
        """Columns that swayaw does not understand, as text."""
    @extra.setter
    def extra(self, value: Any) -> None: ...
    @staticmethod
    def from_dataframe(frame, *, time: Optional[str] = ..., name: Optional[str] = ..., rudder_positive: str = ..., manoeuvre: Optional[str] = ..., execute: Optional[float] = ..., water_depth: Optional[float] = ..., reference_x: float = ...) -> Recording:
        """A recording from a pandas.DataFrame whose columns are named as in recording files: psi_deg, r_rad_s, delta_deg …
        
        Each column is copied once, into SI. Time is the column `time`, else time_s, else the index: seconds, or dates, which
        count from the first. Columns that are not understood are kept as text. What is not given is taken from `frame.attrs`
        as `to_dataframe` leaves it there.
        
        rudder_positive: side to which rudder angles of the frame are positive. execute: time of the first rudder order [s].
        water_depth [m]. reference_x: point of which positions and velocities are, forward of midship [m]. With it, and with
        latitude and longitude, the frame goes through the text of a file and is copied more often."""
    @property
    def group(self) -> str:
        """Runs with instruments, loading and surroundings in common: the run key `group`, else the day of `start_utc`, else ""."""
    @property
    def manoeuvre(self) -> str:
        """\"zigzag 10/10", "turn 35", free text; empty if not said."""
    @manoeuvre.setter
    def manoeuvre(self, value: Any) -> None: ...
    @property
    def name(self) -> str:
        """File name, or what made it."""
    @name.setter
    def name(self, value: Any) -> None: ...
    def plot(run, axes=...) -> Any:
        """Every channel of a recording over time, one below the other."""
    @property
    def remarks(self) -> dict:
        """Run keys that the recording carries along, as TOML: {"group": '"calm"'}."""
    @remarks.setter
    def remarks(self, value: Any) -> None: ...
    @property
    def time(self) -> numpy.ndarray:
        """Times [s], numpy.ndarray."""
    def to_dataframe(self: Recording, copy: bool = ...) -> Any:
        """The recording as a pandas.DataFrame: time_s, the SI columns that were recorded, and columns that swayaw does not
        understand. `attrs` holds name, manoeuvre, execute_s, water_depth_m and the other run keys.
        
        copy=False: the columns are the samples themselves, without a copy; writing to them changes the recording."""
    @property
    def water_depth(self) -> Optional[float]:
        """[m]"""
    @water_depth.setter
    def water_depth(self, value: Any) -> None: ...
    def write_csv(self: Recording, file: Union[str, 'PathLike[str]']) -> None:
        """Writes a recording file, all of it or nothing. Raises FileError if it cannot be written."""

class Refusal(ValueError):
    """A question that the data or the model cannot answer; its text says why."""

class RegionError:
    """Errors while one variable lay between two bounds."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> RegionError: ...
    @property
    def bias(self) -> float:
        """Mean, simulated minus recorded."""
    @property
    def high(self) -> Optional[float]:
        """Likewise."""
    @property
    def low(self) -> Optional[float]:
        """[rad], yaw rate rL/U; None for an open bound."""
    @property
    def rms(self) -> float:
        """SI."""
    @property
    def samples(self) -> int:
        """In it."""
    @property
    def share(self) -> float:
        """Of all squared errors."""
    @property
    def variable(self) -> str:
        """drift, yaw rate or rudder."""
    @property
    def words(self) -> str:
        """\"rudder 15 to 25 deg to port\""""

class Regression:
    """Coefficients of y = X b + e and what the data tell of them."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Regression: ...
    @property
    def R2(self) -> float:
        """Share of the variance of y about its mean that is explained."""
    def __getitem__(self: Regression, name: str) -> Coefficient:
        """The coefficient of that name; Refusal where there is none."""
    @property
    def autoregression(self) -> numpy.ndarray:
        """phi of the residuals; empty where independent."""
    @property
    def coefficients(self) -> List[Coefficient]:
        """In the order of the columns."""
    @property
    def condition_number(self) -> float:
        """Of the features, columns scaled to one size."""
    @property
    def covariance(self) -> numpy.ndarray:
        """Of the coefficients."""
    @property
    def degrees_of_freedom(self) -> float:
        """Of the intervals."""
    @property
    def error_size(self) -> float:
        """Factor on the covariances that total least squares finds; else 1."""
    @property
    def iterations(self) -> int:
        """Of autoregression or noise."""
    @property
    def residual_rms(self) -> float:
        """Of them."""
    @property
    def residuals(self) -> numpy.ndarray:
        """y - X b"""
    @property
    def samples(self) -> float:
        """Effective number, less than the rows where residuals are correlated."""
    @property
    def solver(self) -> str:
        """normal equations, QR or SVD."""
    @property
    def status(self) -> str:
        """converged, iteration limit or rank deficient."""
    @property
    def undetermined(self) -> List[Combination]:
        """Worst first."""

class Resample:
    """Coefficients from some of the runs."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Resample: ...
    @property
    def runs(self) -> str:
        """\"all but zz10.csv", "zz10.csv alone", "rudder 20 deg alone\""""
    @property
    def values(self) -> List[Optional[float]]:
        """In the order of the parameters; None where not determined."""

class Reversal:
    """A rudder reversal and the heading peak that follows."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Reversal: ...
    @property
    def overshoot(self) -> Optional[float]:
        """Heading peak beyond the switch angle [rad]."""
    @property
    def peak_time(self) -> Optional[float]:
        """When the yaw rate passes zero [s]."""
    @property
    def time(self) -> float:
        """When the heading reaches the switch angle [s]."""

class ReverseSpiral:
    """Bech's reverse spiral."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ReverseSpiral: ...
    @property
    def approach_speed(self) -> float:
        """[m/s]"""
    @property
    def points(self) -> List[HeldYawRate]:
        """From the largest yaw rate to port to the largest to starboard."""
    @property
    def propulsion(self) -> Controls:
        """Held."""

class RudderHistory:
    """Rudder angle over dimensionless time, straight lines between the points and held after the last. Two points at one time are a step."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> RudderHistory: ...
    def __init__(self, s: numpy.ndarray = ..., delta: numpy.ndarray = ...) -> None: ...
    @property
    def delta(self) -> numpy.ndarray:
        """Rudder angle [rad], positive to port."""
    @property
    def s(self) -> numpy.ndarray:
        """Ship lengths, never descending."""

class RudderLine:
    """Rudder angle that changes linearly: value + rate s."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> RudderLine: ...
    def __init__(self, value: float = ..., rate: float = ...) -> None: ...
    @property
    def rate(self) -> float:
        """Per ship length [rad]."""
    @property
    def value(self) -> float:
        """At the start [rad]."""

class RudderMove:
    """A rudder order as it was carried out."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> RudderMove: ...
    @property
    def after(self) -> float:
        """Angle held after [rad]."""
    @property
    def before(self) -> float:
        """Angle before, positive to port [rad]."""
    @property
    def rate(self) -> Optional[float]:
        """Mean of the middle part of the way [rad/s]."""
    @property
    def start(self) -> Told:
        """[s]"""

class RunCheck:
    """What kinematics say of the instruments of one run."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> RunCheck: ...
    def _repr_html_(self) -> str: ...
    @property
    def cannot_tell(self) -> List[str]:
        """What this run has no channels or no motion for."""
    @property
    def channels(self) -> List[ChannelCharacter]:
        """What the samples are like."""
    @property
    def derived(self) -> List[DerivedChannel]:
        """Channels that were not measured."""
    @property
    def errors(self) -> List[InstrumentError]:
        """Those that could be told, and those that could not: `told`."""
    @property
    def gaps(self) -> numpy.ndarray:
        """Begin, end, begin, end … without samples [s]."""
    @property
    def group(self) -> str:
        """As Recording.group."""
    @property
    def mistake(self) -> Optional[InstrumentError]:
        """The first that forbids to believe the run, if there is one."""
    @property
    def run(self) -> str:
        """Its name."""
    @property
    def told(self) -> List[InstrumentError]:
        """The errors that were told."""

class RunErrors:
    """Errors of replays over windows of two ship lengths."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> RunErrors: ...
    @property
    def after(self) -> List[QuantityError]:
        """With the effects."""
    @property
    def before(self) -> List[QuantityError]:
        """Of the ship as given."""
    @property
    def refitted(self) -> List[QuantityError]:
        """Of her coefficients refitted."""
    @property
    def run(self) -> str:
        """Its name."""

class RunPicture:
    """A run as people look at it: at most 500 points."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> RunPicture: ...
    @property
    def after(self) -> Optional[Recording]:
        """Replay with the effects."""
    @property
    def given(self) -> Optional[Recording]:
        """Replay by the ship as given."""
    @property
    def missing_after(self) -> List[MissingForce]:
        """Force that the ship with the effects lacks."""
    @property
    def missing_before(self) -> List[MissingForce]:
        """Force that the refitted ship lacks."""
    def plot(picture, axes=...) -> Any:
        """Yaw moment that the refitted ship, and the ship with the effects, lack in a run; bands of two deviations."""
    @property
    def recorded(self) -> Recording:
        """The run."""
    @property
    def refitted(self) -> Optional[Recording]:
        """Replay by the refitted ship."""
    @property
    def run(self) -> str:
        """Its name."""

class SecondOrderTold:
    """T1 T2 d²r/dt² + (T1 + T2) dr/dt + r = K (delta + T3 d(delta)/dt), the same sign."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SecondOrderTold: ...
    @property
    def K(self) -> Told:
        """[1/s]"""
    @property
    def K_told(self) -> bool:
        """Its standard error is no more than half of it."""
    @property
    def T1(self) -> Optional[Told]:
        """[s]; None for a complex pair."""
    @property
    def T1T2(self) -> Told:
        """[s²]"""
    @property
    def T1_plus_T2(self) -> Told:
        """[s]"""
    @property
    def T1_told(self) -> bool:
        """Likewise."""
    @property
    def T2(self) -> Optional[Told]:
        """[s]; None for a complex pair."""
    @property
    def T2_told(self) -> bool:
        """Likewise."""
    @property
    def T3(self) -> Told:
        """[s]"""
    @property
    def T3_told(self) -> bool:
        """Likewise."""

class SharedCoefficient:
    """A coefficient of the class."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SharedCoefficient: ...
    @property
    def deviations(self) -> float:
        """found − given over what the file says of it."""
    @property
    def found(self) -> float:
        """SI"""
    @property
    def given(self) -> float:
        """SI"""
    @property
    def key(self) -> str:
        """Of ship files."""
    @property
    def standard_error(self) -> float:
        """SI"""

class Ship:
    """A ship of a nonlinear model, what surrounds her, and what her model leaves out.
    
    She is a value: `with_values` and `with_effect` give another ship. Two ships are equal when their files are."""
    @property
    def effects(self) -> List[Effect]:
        """What her model leaves out, as Effect."""
    @property
    def feels_wind(self) -> bool:
        """Whether she shows the wind anything: without areas above water no wind acts on her."""
    @property
    def length(self) -> float:
        """Between perpendiculars [m]."""
    @property
    def model(self) -> str:
        """\"mmg", "pi", "pu" or "abkowitz"."""
    @property
    def name(self) -> str: ...
    @name.setter
    def name(self, value: Any) -> None: ...
    def parameter_table(self) -> Any:
        """The parameters of a ship as a pandas.DataFrame by name: table, value, unit, low, high, deviation, role."""
    @property
    def parameters(self) -> dict:
        """All parameters of her model by name, as Parameter."""
    def save(self: Ship, file: Union[str, 'PathLike[str]'], remark: str = ...) -> None:
        """Writes her ship file, whole or not at all."""
    @property
    def service_speed(self) -> float:
        """At which she approaches a manoeuvre unless told otherwise [m/s]."""
    @property
    def steering_gear(self) -> SteeringGear:
        """What her steering gear can do."""
    def text(self: Ship, remark: str = ...) -> str:
        """The text of her ship file, which parse_ship reads back to the same ship."""
    @property
    def time_unit(self) -> float:
        """In which she sails her length at service speed, L/U [s]."""
    @overload
    def with_effect(self: Ship, effect: Effect) -> Ship: ...
    @overload
    def with_effect(self: Ship, id: str, **kwargs) -> Ship:
        """with_effect(*args, **kwargs)
        
        The ship with one more effect. Raises Refusal where it cannot act on her.
        
        The same from id and numbers: ship.with_effect("steady_current", …)."""
    def with_values(self: Ship, values: Dict[str, float]) -> Ship:
        """The ship with other values of parameters, by name, in the units of the ship file: ship.with_values({"N_v": -0.14}). Raises Refusal for a name she does not have, ValueError out of range."""
    def without_effects(self: Ship) -> Ship:
        """The ship as her model has her."""

class ShipState:
    """Where the ship is, where she points, how she moves."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ShipState: ...
    def __init__(self, x: float = ..., y: float = ..., psi: float = ..., motion: PlanarMotion = ...) -> None: ...
    @property
    def motion(self) -> PlanarMotion:
        """Through the water."""
    @property
    def psi(self) -> float:
        """Heading, clockwise from north [rad]."""
    @property
    def x(self) -> float:
        """Midship, earth-fixed, northward [m]."""
    @property
    def y(self) -> float:
        """Midship, earth-fixed, eastward [m]."""

class SimulationCount:
    """Manoeuvres that were sailed."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SimulationCount: ...
    @property
    def turns(self) -> int:
        """Turning circles."""
    @property
    def zigzags(self) -> int: ...

class Simulator:
    """A ship in real time with all her effects: what a ship-handling simulator steps.
    
        ship = Simulator(published_ship("kvlcc2"))
        ship.order_rudder(math.radians(-20))
        ship.step(0.02)
    
    Motion is through the water. Controls, wind, current and a force of the user's own are held until given anew; each raises
    ValueError unless the numbers are finite. Steps are those of the classical Runge–Kutta method, none longer than
    `longest_step` in L/U_0; the same calls give the same motion."""
    def __init__(self: Simulator, ship: Ship, *, longest_step: float = ..., speed: Optional[float] = ...) -> None:
        """At the origin on heading 0, straight ahead with the propulsion that carries her at that speed [m/s], the service speed unless given."""
    @property
    def forces(self) -> dict:
        """By part: PlanarForce."""
    @property
    def heel(self) -> float:
        """Starboard side down [rad]; 0 without roll coupling."""
    @property
    def instruments(self) -> dict:
        """What the instruments show, by column."""
    def order_rudder(self: Simulator, angle: float) -> None:
        """Rudder angle, positive to port [rad], through the steering gear."""
    @property
    def rudder(self) -> float:
        """Angle of the rudder, positive to port [rad]."""
    @property
    def rudder_shown(self) -> float:
        """Angle that the indicator shows [rad]."""
    def set_added_force(self: Simulator, force: PlanarForce) -> None:
        """A force in body axes beside all others, about midship: tugs, lines, own waves."""
    def set_current(self: Simulator, speed: float, to: float) -> None:
        """Current [m/s] and where it runs to [rad]; the motion through the water stays as it is."""
    def set_rudder(self: Simulator, angle: float) -> None:
        """The indicator shows that angle [rad] at once."""
    def set_shaft_speed(self: Simulator, rev: float) -> None:
        """[1/s]. Raises Refusal where the model takes none."""
    def set_state(self: Simulator, state: ShipState) -> None:
        """Place, heading and motion through the water."""
    def set_thrust(self: Simulator, thrust: float) -> None:
        """Of all propellers [N], in place of a shaft speed. Raises Refusal where the model takes none."""
    def set_wind(self: Simulator, speed: float, wind_from: float) -> None:
        """True wind [m/s] and where it comes from, clockwise from north [rad]. Raises Refusal if nothing is known of what she shows the wind."""
    @property
    def shaft_speed(self) -> float:
        """As ordered [1/s]."""
    @property
    def state(self) -> ShipState:
        """The motion is through the water: ShipState."""
    def step(self: Simulator, dt: float) -> None:
        """Goes on by dt [s]; does nothing unless dt > 0."""
    @property
    def thrust(self) -> float:
        """Of all propellers [N]; NaN where the model does not tell it."""
    @property
    def time(self) -> float:
        """Since the beginning [s]."""
    @property
    def valid(self) -> bool:
        """Whether the force model holds where the ship is."""
    @property
    def velocity_over_ground(self) -> PlanarMotion: ...
    @property
    def why(self) -> str:
        """Else what carries it on, in words."""

class SnameDerivatives:
    """Linear derivatives in the SNAME form, all primed in one system:
    
        (m' - Y_vdot) dv'/ds' + (m' x_G - Y_rdot) dr'/ds' = Y_v v' + (Y_r - m') r' + Y_delta delta
        (m' x_G - N_vdot) dv'/ds' + (I_z - N_rdot) dr'/ds' = N_v v' + (N_r - m' x_G) r' + N_delta delta
    
    about midship, v' = v/U = -beta, r' = omega'."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SnameDerivatives: ...
    @property
    def I_z(self) -> float:
        """Moment of inertia about midship."""
    @property
    def N_delta(self) -> float:
        """Yaw."""
    @property
    def N_r(self) -> float:
        """Yaw."""
    @property
    def N_rdot(self) -> float:
        """Added mass."""
    @property
    def N_v(self) -> float:
        """Yaw."""
    @property
    def N_vdot(self) -> float:
        """Added mass."""
    @property
    def Y_delta(self) -> float:
        """Sway."""
    @property
    def Y_r(self) -> float:
        """Sway."""
    @property
    def Y_rdot(self) -> float:
        """Added mass."""
    @property
    def Y_v(self) -> float:
        """Sway."""
    @property
    def Y_vdot(self) -> float:
        """Added mass."""
    def __init__(self, m: float = ..., x_G: float = ..., I_z: float = ..., Y_vdot: float = ..., Y_rdot: float = ..., N_vdot: float = ..., N_rdot: float = ..., Y_v: float = ..., Y_r: float = ..., Y_delta: float = ..., N_v: float = ..., N_r: float = ..., N_delta: float = ...) -> None: ...
    @property
    def m(self) -> float:
        """Mass."""
    @property
    def x_G(self) -> float:
        """Centre of gravity forward of midship over length."""

class Spiral:
    """Dieudonné's spiral."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Spiral: ...
    @property
    def approach_speed(self) -> float:
        """[m/s]"""
    @property
    def curve(self) -> List[SteadyTurn]:
        """All steady turns up to the largest angle, the unstable ones too."""
    @property
    def down(self) -> List[SpiralPoint]:
        """From the largest angle on the first side to the largest on the other."""
    @property
    def exact(self) -> Optional[InstabilityLoop]:
        """Loop of that curve."""
    @property
    def loop(self) -> Optional[SpiralLoop]:
        """Of the two; None where they agree."""
    def plot(result, axes=...) -> Any:
        """Yaw rate over rudder angle: as sailed down and up, and the curve of all steady turns."""
    @property
    def propulsion(self) -> Controls:
        """Held during the manoeuvre."""
    @property
    def run(self) -> Recording:
        """The time series."""
    @property
    def up(self) -> List[SpiralPoint]:
        """And back."""

class SpiralLoop:
    """Where the way out and the way back differ."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SpiralLoop: ...
    @property
    def height(self) -> float:
        """Largest difference of yaw rate at one rudder angle [rad/s]."""
    @property
    def width(self) -> float:
        """Between the outermost such rudder angles [rad]."""

class SpiralPoint:
    """What became of the ship at one rudder angle."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SpiralPoint: ...
    @property
    def delta(self) -> float:
        """Rudder angle, positive to port [rad]."""
    @property
    def held(self) -> float:
        """Time since the order [s]."""
    @property
    def motion(self) -> PlanarMotion:
        """At the end."""
    @property
    def settled(self) -> bool:
        """The motion was steady."""

class SpiralStep:
    """A rudder angle of a recorded spiral."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SpiralStep: ...
    @property
    def begin(self) -> float:
        """[s]"""
    @property
    def delta(self) -> float:
        """Rudder held, positive to port [rad]."""
    @property
    def end(self) -> float:
        """[s]"""
    @property
    def yaw_rate(self) -> Told:
        """Of the second half [rad/s]."""

class SpiralTrial:
    """A recorded spiral."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SpiralTrial: ...
    @property
    def loop_height(self) -> Optional[Told]:
        """Largest difference of yaw rate at one rudder angle [rad/s]."""
    @property
    def loop_width(self) -> Optional[float]:
        """Between the outermost rudder angles with two yaw rates [rad]."""
    @property
    def steps(self) -> List[SpiralStep]:
        """As they were sailed."""

class StabilityVerdict:
    """Whether the fitted ship keeps a straight course."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> StabilityVerdict: ...
    @property
    def e0(self) -> float:
        """Stable where positive: 1/(T1' T2')."""
    @property
    def linear_hull(self) -> bool:
        """The fitted hull has no nonlinear term in sway and yaw."""
    @property
    def range(self) -> MotionRange: ...
    @property
    def standard_error(self) -> float: ...
    @property
    def straight_course(self) -> str:
        """stable, unstable or not_told."""
    @property
    def words(self) -> str:
        """One sentence."""

class StateEstimate:
    """Where a recorded ship really was, how she moved, and what pushed her."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> StateEstimate: ...
    @property
    def converged(self) -> bool:
        """True where nothing had to be estimated."""
    @property
    def covariances(self) -> numpy.ndarray:
        """Samples by 9 by 9."""
    @property
    def innovations(self) -> List[ChannelInnovation]:
        """By channel."""
    @property
    def iterations(self) -> int:
        """Of the estimation of the noise."""
    @property
    def log_likelihood(self) -> float:
        """Of all runs."""
    names: Tuple[str, ...]
    @property
    def noise(self) -> dict:
        """Standard deviation by channel, known or estimated, SI."""
    @property
    def process_noise(self) -> PlanarAcceleration:
        """Size of the unmodelled accelerations."""
    def recording(self: StateEstimate, run: Recording) -> Recording:
        """The estimated motion as a recording; rudder and propulsion as in `run`, which it came from."""
    @property
    def states(self) -> numpy.ndarray:
        """A row for each sample, columns as `names`."""
    @property
    def time(self) -> numpy.ndarray:
        """[s]"""

class StateSpace:
    """d(x)/dt = A x + B u,  y = C x + D u; time in seconds, or in ship lengths for `unit` "L/U"."""
    A: numpy.ndarray
    B: numpy.ndarray
    C: numpy.ndarray
    D: numpy.ndarray
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    unit: str
    def to_scipy(self) -> Any:
        """As scipy.signal.StateSpace."""
    def to_control(self) -> Any:
        """As control.StateSpace of python-control, with the names of states, inputs and outputs."""
    @property
    def poles(self) -> numpy.ndarray:
        """Eigenvalues of A."""

class SteadyMotion:
    """A motion in which nothing changes but the place and the heading."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SteadyMotion: ...
    @property
    def motion(self) -> PlanarMotion:
        """Through the water."""
    @property
    def stable(self) -> bool:
        """A small disturbance dies out."""

class SteadyTrial:
    """A recorded steady run."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SteadyTrial: ...
    @property
    def drift(self) -> Optional[Told]:
        """Drift angle through the water [rad]."""
    @property
    def helm(self) -> Told:
        """Mean rudder angle, positive to port [rad]."""
    @property
    def leeway(self) -> Optional[Told]:
        """Of the track over ground, positive to starboard [rad]."""
    @property
    def speed(self) -> Optional[Told]:
        """[m/s]"""
    @property
    def yaw_rate(self) -> Told:
        """[rad/s]"""

class SteadyTurn:
    """A point of the r-delta curve."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SteadyTurn: ...
    @property
    def delta(self) -> float:
        """Rudder angle, positive to port [rad]."""
    @property
    def motion(self) -> PlanarMotion:
        """Steady there."""
    @property
    def stable(self) -> bool:
        """A small disturbance dies out."""

class SteeringGear:
    """How the rudder follows its order."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SteeringGear: ...
    def __init__(self, rate: float = ..., max_angle: float = ..., lag: float = ..., dead_band: float = ...) -> None: ...
    @property
    def dead_band(self) -> float:
        """[rad], 0 for none."""
    @property
    def lag(self) -> float:
        """T [s], 0 for a rudder that keeps its rate until it arrives."""
    @property
    def max_angle(self) -> float:
        """[rad]"""
    @property
    def rate(self) -> float:
        """Largest rate [rad/s]."""

class SteeringIndices:
    """Indices of the second-order equations of drift and yaw, dimensionless:
    
        T1 T2 d²(omega')/ds'² + (T1 + T2) d(omega')/ds' + omega' = Kw (delta + T3w d(delta)/ds'),   beta with Kb and T3b
    
    Kb and Kw are negative for a stable ship, since a rudder angle to port is positive. Source: [Artyszuk2016] eqs (15), (16)"""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SteeringIndices: ...
    @property
    def Kb(self) -> float:
        """Gain of drift."""
    @property
    def Kw(self) -> float:
        """Gain of yaw."""
    @property
    def T1T2(self) -> float:
        """Product of the time constants."""
    @property
    def T1_plus_T2(self) -> float:
        """Their sum."""
    @property
    def T3b(self) -> float:
        """Rudder-rate time constant of drift."""
    @property
    def T3w(self) -> float:
        """Rudder-rate time constant of yaw."""
    def __init__(self, T1T2: float = ..., T1_plus_T2: float = ..., T3b: float = ..., T3w: float = ..., Kb: float = ..., Kw: float = ...) -> None: ...

class SteeringTrial:
    """K and T of a recorded manoeuvre."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SteeringTrial: ...
    @property
    def K_prime(self) -> Optional[Told]:
        """K L/U."""
    @property
    def P(self) -> Optional[Told]:
        """Norrbin's P, as recorded."""
    @property
    def P_of_fit(self) -> Optional[float]:
        """K' (1 - T' + T' exp(-1/T'))."""
    @property
    def T_prime(self) -> Optional[Told]:
        """T U/L."""
    @property
    def least_squares(self) -> Optional[NomotoTold]:
        """Of the heading of the whole manoeuvre."""
    @property
    def second(self) -> Optional[SecondOrderTold]:
        """Second order."""
    @property
    def worked(self) -> Optional[NomotoTold]:
        """Nomoto's own method, without standard errors."""

class SurroundingsEstimate:
    """Wind or stream in a part of the runs."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SurroundingsEstimate: ...
    @property
    def cannot_tell(self) -> str:
        """Why they do not tell a direction, or how much wind they would not have shown."""
    @property
    def parameters(self) -> List[ParameterEstimate]:
        """With standard errors."""
    @property
    def runs(self) -> List[str]:
        """Their names."""
    @property
    def scope(self) -> str:
        """A group, a run, or "all"."""

class SwayYawCoefficients:
    """Linear sway–yaw equations at constant speed, dimensionless time s' = tU/L:
    
        d(beta)/ds'   = a1 beta + b1 omega' + c1 delta
        d(omega')/ds' = a2 beta + b2 omega' + c2 delta
    
    beta drift angle [rad], omega' = rL/U, delta rudder angle positive to port [rad]. Source: [Artyszuk2016] eq. (1)"""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SwayYawCoefficients: ...
    def __init__(self, a1: float = ..., b1: float = ..., c1: float = ..., a2: float = ..., b2: float = ..., c2: float = ...) -> None: ...
    @property
    def a1(self) -> float:
        """Drift by drift."""
    @property
    def a2(self) -> float:
        """Yaw by drift."""
    @property
    def b1(self) -> float:
        """Drift by yaw."""
    @property
    def b2(self) -> float:
        """Yaw by yaw."""
    @property
    def c1(self) -> float:
        """Drift by rudder."""
    @property
    def c2(self) -> float:
        """Yaw by rudder."""
    @property
    def complex_poles(self) -> bool:
        """The poles are a complex pair."""
    @property
    def stable(self) -> bool:
        """Both poles lie in the left half-plane."""
    def state_space(self, heading: bool = ...) -> StateSpace:
        """The coupled equations in dimensionless time: states beta, omega', and psi where `heading` asks for it."""

class SwayYawSplit:
    """The coefficients split by what they come from."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SwayYawSplit: ...
    @property
    def centrifugal(self) -> SwayYawCoefficients:
        """Of the centrifugal force."""
    @property
    def hull(self) -> SwayYawCoefficients:
        """Of the hull."""
    @property
    def rudder(self) -> SwayYawCoefficients:
        """Of the rudder."""
    @property
    def total(self) -> SwayYawCoefficients:
        """Their sum."""

class SwayYawTransfer:
    """Laplace transforms of drift and yaw over that of the rudder:
    
        beta/delta   = (nb1 s + nb0) / (s² + e1 s + e0)
        omega'/delta = (nw1 s + nw0) / (s² + e1 s + e0)
    
    Regular for every ship: stable, unstable, neutral, complex poles, Kb = 0 or Kw = 0."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> SwayYawTransfer: ...
    def __init__(self, e0: float = ..., e1: float = ..., nb0: float = ..., nb1: float = ..., nw0: float = ..., nw1: float = ...) -> None: ...
    @property
    def e0(self) -> float:
        """1/(T1 T2)"""
    @property
    def e1(self) -> float:
        """(T1 + T2)/(T1 T2)"""
    @property
    def nb0(self) -> float:
        """Kb/(T1 T2)"""
    @property
    def nb1(self) -> float:
        """Kb T3b/(T1 T2)"""
    @property
    def nw0(self) -> float:
        """Kw/(T1 T2)"""
    @property
    def nw1(self) -> float:
        """Kw T3w/(T1 T2)"""

class SweepBlock:
    """Results of a block of items; goes between processes."""
    @property
    def count(self) -> int:
        """How many items."""
    @property
    def place(self) -> int:
        """Among the blocks."""

class SweepStore:
    """Results of a sweep in FOLDER/sweep.sqlite; blocks are written whole or not at all.
    
    folder: that the program would have for --out. work: whose results they are. Raises Refusal if the folder holds the results of another plan, or another sweep works in it."""
    def __init__(self: SweepStore, folder: Union[str, 'PathLike[str]'], work: SweepWork) -> None: ...
    def column(self: SweepStore, subject: int, column: int) -> numpy.ndarray:
        """A column of every item of a ship, in their order; not a number where there is none.
        
        subject: which ship. column: which of the columns."""
    @property
    def rest(self) -> List[int]:
        """Blocks that are not there yet."""
    def write(self: SweepStore, blocks: List[SweepBlock]) -> None:
        """All of these blocks or none. Raises Refusal if they cannot be written.
        
        blocks: any."""

class SweepWork:
    """What the plan of a sweep lays out: blocks of items that may be worked on anywhere, in any order, with the same results (docs/sweep.md).
    
    plan: its file (TOML). Raises FileError for a mistake in it, and Refusal for recordings, which the program works on."""
    def __init__(self: SweepWork, plan: Union[str, 'PathLike[str]']) -> None: ...
    def block(self: SweepWork, place: int) -> SweepBlock:
        """Works on a block. Other threads go on meanwhile.
        
        place: among the blocks."""
    @property
    def blocks(self) -> int:
        """Of how many blocks they are."""
    @property
    def columns(self) -> List[str]:
        """Names of the columns; parameters that vary come first."""
    @property
    def items(self) -> int:
        """How many."""
    @property
    def subjects(self) -> List[str]:
        """Names of the ships."""

class T3Map:
    """Loop measures, rows by T3w, columns by T3b; NaN where a ship makes no three reversals."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> T3Map: ...
    @property
    def T3b(self) -> numpy.ndarray:
        """Of the columns."""
    @property
    def T3w(self) -> numpy.ndarray:
        """Of the rows."""
    @property
    def area(self) -> numpy.ndarray:
        """Of the loop [rad]."""
    @property
    def beta_max(self) -> numpy.ndarray:
        """Largest |beta| [rad]."""
    @property
    def omega_at_beta_zero(self) -> numpy.ndarray:
        """|omega'| where beta passes zero."""
    @property
    def omega_max(self) -> numpy.ndarray:
        """Largest |omega'|."""
    @property
    def overshoot1(self) -> numpy.ndarray:
        """First [rad]."""
    @property
    def overshoot2(self) -> numpy.ndarray:
        """Second [rad]."""
    @property
    def period(self) -> numpy.ndarray:
        """Of the limit cycle [ship lengths]."""

class Thrust:
    """Thrust of the propellers by side; of a single propeller the sum counts."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Thrust: ...
    def __init__(self, port: float = ..., starboard: float = ...) -> None: ...
    @property
    def port(self) -> float:
        """[N]"""
    @property
    def starboard(self) -> float:
        """[N]"""

class TimeConstantEstimates:
    """Fitted T1 and T2, dimensionless."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TimeConstantEstimates: ...
    @property
    def T1(self) -> Estimate: ...
    @property
    def T2(self) -> Estimate: ...

class TimeConstants:
    """T1 and T2, real."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TimeConstants: ...
    @property
    def T1(self) -> float:
        """Of the slower mode, negative for an unstable ship."""
    @property
    def T2(self) -> float:
        """Of the faster mode."""
    def __init__(self, T1: float = ..., T2: float = ...) -> None: ...

class Told:
    """A number read from a recording, with the standard error of noise, rounding and sampling."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Told: ...
    def __float__(self: Told) -> float: ...
    @property
    def standard_error(self) -> float:
        """NaN where none was derived."""
    @property
    def value(self) -> float:
        """SI."""

class TrackPlace:
    """Where the ship is on the original track."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TrackPlace: ...
    @property
    def along(self) -> float:
        """Ahead of the place of the first order [m]."""
    @property
    def offset(self) -> float:
        """Beside the track, positive on the side turned to first [m]."""
    @property
    def time(self) -> float:
        """[s]"""

class TrajectoryFit:
    """A ship whose simulation runs through recordings."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TrajectoryFit: ...
    def _repr_html_(self) -> str: ...
    @property
    def best_combination(self) -> str:
        """Which product of powers is known best."""
    @property
    def condition_number(self) -> float:
        """Of combinations of the parameters."""
    @property
    def correlation(self) -> numpy.ndarray:
        """Of the parameters."""
    @property
    def covariance(self) -> numpy.ndarray:
        """Of the parameters, SI."""
    @property
    def iterations(self) -> int: ...
    @property
    def log_likelihood(self) -> float:
        """Of all runs."""
    @property
    def noise(self) -> dict:
        """Standard deviation by channel, SI."""
    @property
    def parameters(self) -> List[FittedParameter]:
        """In the order of the question."""
    @property
    def runs(self) -> List[FittedRun]:
        """In their order."""
    @property
    def sensitivities(self) -> float:
        """How often all runs were sailed with derivatives."""
    @property
    def ship(self) -> Ship:
        """With the fitted parameters."""
    @property
    def status(self) -> str:
        """converged, iteration_limit, stopped or rank_deficient."""
    @property
    def undetermined(self) -> List[str]:
        """Relative error of 50 % and more, worst first."""

class TransferEstimates:
    """Fitted transfer functions, dimensionless."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TransferEstimates: ...
    @property
    def e0(self) -> Estimate: ...
    @property
    def e1(self) -> Estimate: ...
    @property
    def nb0(self) -> Estimate: ...
    @property
    def nb1(self) -> Estimate: ...
    @property
    def nw0(self) -> Estimate: ...
    @property
    def nw1(self) -> Estimate: ...

class TrialManoeuvre:
    """What was sailed."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TrialManoeuvre: ...
    @property
    def heading(self) -> float:
        """H of a zigzag [rad], else 0."""
    @property
    def kind(self) -> str:
        """zigzag, turn, spiral or steady run."""
    @property
    def name(self) -> str:
        """\"zigzag 10/10", "turn 35" …"""
    @property
    def rudder(self) -> float:
        """D [rad]; 0 of a steady run."""
    @property
    def said(self) -> bool:
        """By the run itself; else told from rudder and heading."""

class TrialResult:
    """A recorded manoeuvre judged."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TrialResult: ...
    def _repr_html_(self) -> str: ...
    @property
    def against_rudder(self) -> bool:
        """The sign of the rudder is wrong."""
    @property
    def approach(self) -> Approach:
        """Before the first rudder order."""
    @property
    def imo(self) -> List[JudgedCriterion]:
        """Empty without length or speed."""
    @property
    def manoeuvre(self) -> TrialManoeuvre:
        """What was sailed."""
    @property
    def notes(self) -> List[str]:
        """What cannot be told and why."""
    def plot(result, run, axes=...) -> Any:
        """Heading and rudder of a recorded manoeuvre from its execute on, with the heading of the fitted K and T."""
    @property
    def rudder(self) -> List[RudderMove]:
        """Orders as they were carried out."""
    @property
    def run(self) -> str:
        """Its name."""
    @property
    def spiral(self) -> Optional[SpiralTrial]:
        """If it is one."""
    @property
    def steady(self) -> Optional[SteadyTrial]:
        """If it is one."""
    @property
    def steering(self) -> SteeringTrial:
        """K and T."""
    @property
    def time_10(self) -> Optional[Told]:
        """From the execute to 10 deg change of heading [s]."""
    @property
    def turn(self) -> Optional[TurnTrial]:
        """If it is one."""
    @property
    def zigzag(self) -> Optional[ZigzagTrial]:
        """If it is one."""

class TrialReversal:
    """A heading peak of a recorded zigzag, and the execute before it."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TrialReversal: ...
    @property
    def beyond_start(self) -> Optional[Told]:
        """Of the peak beyond heading_then [rad]."""
    @property
    def execute(self) -> Optional[Told]:
        """The heading passes H [s]."""
    @property
    def heading_then(self) -> Optional[Told]:
        """Heading off the approach then [rad]."""
    @property
    def overshoot(self) -> Optional[Told]:
        """Of the peak beyond H [rad]."""
    @property
    def overshoot_time(self) -> Optional[Told]:
        """From execute to peak [s]."""
    @property
    def peak_time(self) -> Optional[Told]:
        """[s]"""
    @property
    def rudder_start(self) -> Optional[Told]:
        """The rudder begins to go back [s]."""
    @property
    def side(self) -> str:
        """To which the heading is off."""

class TunedIndex:
    """An index before and after, SI; NaN where it does not exist."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TunedIndex: ...
    @property
    def after(self) -> float:
        """Of the tuned ship."""
    @property
    def before(self) -> float:
        """Of the ship as given."""
    @property
    def measured(self) -> MeasuredIndex:
        """What was measured."""
    @property
    def trial(self) -> int:
        """Place among the measured trials."""

class TunedParameter:
    """A number that was tuned."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TunedParameter: ...
    @property
    def after(self) -> float:
        """In the unit of the file."""
    @property
    def at_bound(self) -> bool:
        """Held by most_change or the range of the ship file."""
    @property
    def before(self) -> float:
        """In the unit of the file."""
    @property
    def determined(self) -> bool:
        """The indices tell it: `told` is 0.5 at least."""
    @property
    def deviation(self) -> float:
        """And after."""
    @property
    def name(self) -> str:
        """Key of the ship file."""
    @property
    def number(self) -> Parameter:
        """As it was."""
    @property
    def prior(self) -> float:
        """Relative standard deviation before; infinity for none."""
    @property
    def told(self) -> float:
        """Share, in squares, that lies in determined combinations."""
    @property
    def value(self) -> float:
        """As it is, SI."""

class Tuning:
    """A ship whose manoeuvres have the indices that were measured."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Tuning: ...
    def _repr_html_(self) -> str: ...
    @property
    def after(self) -> TuningError:
        """Error of the tuned ship."""
    @property
    def before(self) -> TuningError:
        """Error of the ship as given."""
    @property
    def combinations(self) -> List[IndexCombination]:
        """That the indices determine, of the ship as she was."""
    @property
    def decay(self) -> numpy.ndarray:
        """Of each turn after tuning, per ship length; NaN where none was asked for."""
    @property
    def indices(self) -> List[TunedIndex]:
        """Before and after."""
    @property
    def parameters(self) -> List[TunedParameter]:
        """Before and after."""
    @property
    def ship(self) -> Ship:
        """With the numbers found."""
    @property
    def simulations(self) -> SimulationCount:
        """That it took."""
    @property
    def status(self) -> str:
        """converged, simulation_limit or interrupted."""

class TuningError:
    """Σ (1 − I/I_measured)². Source: [Kulbiej2021] section 4.1"""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TuningError: ...
    @property
    def turns(self) -> float:
        """Of turning circles."""
    @property
    def zigzags(self) -> float: ...

class TurnOrder:
    """A turn with the rudder held."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TurnOrder: ...
    def __init__(self, rudder: float = ..., side: str = ...) -> None: ...
    @property
    def rudder(self) -> float:
        """[rad], positive."""
    @property
    def side(self) -> str:
        """Turned to."""

class TurnTrial:
    """A recorded turning circle."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TurnTrial: ...
    @property
    def corrected(self) -> Optional[CircleTold]:
        """Of the track without that drift."""
    @property
    def drift(self) -> Optional[DriftTold]:
        """None where the turn does not tell it."""
    @property
    def final_drift(self) -> Optional[Told]:
        """Drift angle [rad]."""
    @property
    def final_speed(self) -> Optional[Told]:
        """[m/s]"""
    @property
    def final_yaw_rate(self) -> Optional[Told]:
        """Positive to starboard [rad/s]."""
    @property
    def gain(self) -> Optional[Told]:
        """Final yaw rate over rudder angle [1/s]."""
    @property
    def heading_change(self) -> float:
        """In all [rad]."""
    @property
    def recorded(self) -> CircleTold:
        """Of the track as it was recorded."""
    @property
    def residual_yaw_rate(self) -> Optional[Told]:
        """Pull-out: left after the rudder went amidships [rad/s]."""
    @property
    def side(self) -> str:
        """Turned to."""
    @property
    def speed_kept(self) -> Optional[Told]:
        """Final over approach speed."""
    @property
    def time_180(self) -> Optional[Told]:
        """[s]"""
    @property
    def time_270(self) -> Optional[Told]:
        """[s]"""
    @property
    def time_360(self) -> Optional[Told]:
        """[s]"""
    @property
    def time_90(self) -> Optional[Told]:
        """From the execute [s]."""

class TurningCircle:
    """A simulated turning circle and its indices; None for what was not reached."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> TurningCircle: ...
    def _repr_html_(self) -> str: ...
    @property
    def advance(self) -> Optional[float]:
        """Forward way at 90 deg change of heading [m]."""
    @property
    def approach_speed(self) -> float:
        """[m/s]"""
    @property
    def final_diameter(self) -> Optional[float]:
        """2U/|r| of the steady turn [m]."""
    @property
    def initial_turning(self) -> Optional[float]:
        """Way made at 10 deg change of heading [m]."""
    def plot(result, axes=...) -> Any:
        """The track of a turning circle with advance and tactical diameter."""
    @property
    def propulsion(self) -> Controls:
        """Held during the manoeuvre."""
    @property
    def run(self) -> Recording:
        """The time series."""
    @property
    def steady(self) -> Optional[PlanarMotion]:
        """The steady turn, if the ship settles in one."""
    @property
    def tactical_diameter(self) -> Optional[float]:
        """Sideways way at 180 deg [m]."""
    @property
    def time_180(self) -> Optional[float]:
        """[s]"""
    @property
    def time_90(self) -> Optional[float]:
        """[s]"""
    @property
    def transfer(self) -> Optional[float]:
        """Sideways way at 90 deg [m]."""
    @property
    def way_lost(self) -> Optional[float]:
        """When the ship ceased to move ahead, which ended the turn [s]."""

class Unknown:
    """A number to be estimated and what is known of it beforehand."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Unknown: ...
    def __init__(self, name: str = ..., mean: float = ..., deviation: float = ..., low: float = ..., high: float = ..., step: float = ...) -> None: ...
    @property
    def deviation(self) -> float:
        """Standard deviation about the mean beforehand."""
    @property
    def high(self) -> float:
        """Bound."""
    @property
    def low(self) -> float:
        """Bound."""
    @property
    def mean(self) -> float:
        """Where nothing is known, and where the search begins."""
    @property
    def name(self) -> str:
        """By which the function of ships gets it."""
    @property
    def step(self) -> float:
        """Of differences, over which residuals are about linear."""

class VesselChange:
    """Something of one vessel that is not as it was."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> VesselChange: ...
    @property
    def after(self) -> float:
        """The parameter on her last day, SI."""
    @property
    def before(self) -> float:
        """The parameter before it began, SI."""
    @property
    def days(self) -> List[DayLevel]:
        """The parameter day by day."""
    @property
    def effect(self) -> Effect:
        """As it is on her last day."""
    @property
    def floors(self) -> float:
        """|after − before| over the least size that matters."""
    @property
    def key(self) -> str:
        """Of its parameter."""
    @property
    def log_evidence_gain(self) -> float: ...
    @property
    def probability(self) -> float:
        """Against others in its place, and against none."""
    @property
    def shape(self) -> str: ...
    @property
    def since(self) -> DateEstimate:
        """When it began."""
    @property
    def standard_error(self) -> float:
        """Of after − before."""

class VesselDifference:
    """In what a vessel differs from her sisters from the first day on."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> VesselDifference: ...
    @property
    def effect(self) -> Effect: ...
    @property
    def floors(self) -> float:
        """|own − sisters| over the least size that matters."""
    @property
    def key(self) -> str:
        """Of its parameter."""
    @property
    def own(self) -> float:
        """SI"""
    @property
    def sisters(self) -> float:
        """SI"""
    @property
    def standard_error(self) -> float:
        """Of own − sisters."""

class VesselReport:
    """What was found of one vessel."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> VesselReport: ...
    @property
    def changes(self) -> List[VesselChange]:
        """Largest over its floor first."""
    @property
    def days(self) -> int:
        """That were fitted."""
    @property
    def differences(self) -> List[VesselDifference]:
        """From her sisters, or from the ship file."""
    @property
    def errors(self) -> FleetErrors: ...
    @property
    def first_day(self) -> float:
        """Days since 1970-01-01."""
    @property
    def last_day(self) -> float:
        """Days since 1970-01-01."""
    @property
    def runs(self) -> int: ...
    @property
    def today(self) -> Ship:
        """As she is on her last day."""
    @property
    def vessel(self) -> str:
        """Her name."""

class WilliamsonTurn:
    """Back along the own track."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> WilliamsonTurn: ...
    def _repr_html_(self) -> str: ...
    @property
    def amidships(self) -> Optional[TrackPlace]:
        """Rudder ordered amidships."""
    @property
    def approach_speed(self) -> float:
        """[m/s]"""
    @property
    def heading(self) -> float:
        """Change of heading at the end, to the side turned to first [rad]."""
    @property
    def propulsion(self) -> Controls:
        """Held during the manoeuvre."""
    @property
    def reciprocal(self) -> Optional[TrackPlace]:
        """Heading opposite to the approach."""
    @property
    def run(self) -> Recording:
        """The time series."""
    @property
    def shifted(self) -> Optional[TrackPlace]:
        """Rudder ordered to the other side."""
    @property
    def way(self) -> Optional[float]:
        """Made from the first order until then [m]."""
    @property
    def yaw_rate(self) -> float:
        """At the end, positive to starboard [rad/s]."""

class WindRun:
    """A straight run in steady wind on which nothing changes but the place."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> WindRun: ...
    @property
    def course(self) -> float:
        """Over ground [rad]."""
    @property
    def delta(self) -> float:
        """Helm, positive to port [rad]."""
    @property
    def holds(self) -> bool:
        """The helm is within the largest rudder angle."""
    @property
    def leeway(self) -> float:
        """Of the track through the water, positive to starboard of the heading [rad]."""
    @property
    def motion(self) -> PlanarMotion:
        """Through the water; r = 0."""
    @property
    def psi(self) -> float:
        """Heading [rad]."""
    @property
    def speed_over_ground(self) -> float:
        """[m/s]"""
    @property
    def wind_force(self) -> PlanarForce:
        """[N], [N m]"""

class WorstInterval:
    """Part of a run that holds most of the error above the run's mean."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> WorstInterval: ...
    @property
    def begin(self) -> float:
        """[s]"""
    @property
    def end(self) -> float:
        """[s]"""
    @property
    def rms(self) -> float:
        """SI."""
    @property
    def share(self) -> float:
        """Of all squared errors."""

class Zigzag:
    """A simulated zigzag and its indices. Source: IMO resolution MSC.137(76)."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> Zigzag: ...
    def _repr_html_(self) -> str: ...
    @property
    def approach_speed(self) -> float:
        """[m/s]"""
    @property
    def initial_turning(self) -> Optional[float]:
        """Way made when the heading first reaches H [m]."""
    @property
    def period(self) -> Optional[float]:
        """Of the last full cycle, reversal to the next but one [s]."""
    def plot(result, axes=...) -> Any:
        """Heading and rudder of a zigzag; the peaks are marked."""
    @property
    def propulsion(self) -> Controls:
        """Held during the manoeuvre."""
    @property
    def reversals(self) -> List[Reversal]:
        """In their order."""
    @property
    def run(self) -> Recording:
        """The time series."""

class ZigzagBatch:
    """Zigzags of many ships: reversals by ships; NaN for what a ship did not reach."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ZigzagBatch: ...
    @property
    def count(self) -> numpy.ndarray:
        """Overshoots of each ship."""
    @property
    def end(self) -> List[str]:
        """Of each ship: complete, time_over, unbounded or no_propulsion."""
    @property
    def overshoot(self) -> numpy.ndarray:
        """Heading peak beyond the switch angle [rad]."""
    @property
    def peak_time(self) -> numpy.ndarray:
        """When the yaw rate passes zero [s]."""
    @property
    def reversals(self) -> int:
        """Asked for."""
    @property
    def ships(self) -> int:
        """How many."""
    @property
    def time(self) -> numpy.ndarray:
        """When the heading reaches the switch angle [s]."""

class ZigzagOrder:
    """A zigzag."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ZigzagOrder: ...
    def __init__(self, rudder: float = ..., heading: float = ..., first: str = ...) -> None: ...
    @property
    def first(self) -> str:
        """Side turned to first."""
    @property
    def heading(self) -> float:
        """At which the rudder is reversed [rad], positive."""
    @property
    def rudder(self) -> float:
        """[rad], positive."""

class ZigzagTrial:
    """A recorded zigzag."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ZigzagTrial: ...
    @property
    def broken_off(self) -> bool:
        """The rudder was reversed before the heading reached H."""
    @property
    def end(self) -> float:
        """Of the zigzag [s]."""
    @property
    def first(self) -> str:
        """Side turned to first."""
    @property
    def initial_turning(self) -> Optional[Told]:
        """Way made when the heading first reaches H [m]."""
    @property
    def period(self) -> Optional[Told]:
        """Of the last full cycle [s]."""
    @property
    def reach(self) -> Optional[Told]:
        """From the first execute until the heading is back [s]."""
    @property
    def reversals(self) -> List[TrialReversal]:
        """In their order."""

class ZigzagView:
    """A zigzag by Nomoto's first-order equation and its drift–yaw loop."""
    def _asdict(self) -> Dict[str, Any]: ...
    def _replace(self, **values: Any) -> ZigzagView: ...
    @property
    def K(self) -> float:
        """K L/U, rudder positive to port."""
    @property
    def T(self) -> float:
        """T U/L."""
    @property
    def delta_r(self) -> float:
        """Rudder offset beside the recorded angle [rad]."""
    @property
    def loop_area(self) -> float:
        """∮ beta d(r') over one period; NaN without sway velocity."""

def assumed_propulsion(ship: Ship, runs: List[Recording]) -> str:
    """What is assumed of those runs that do not tell what propels her, in words; empty where all do.
    
    ship: who sails. runs: recordings."""

def bandwidth(transfer: SwayYawTransfer, of: str) -> Optional[float]:
    """Frequency [radians per ship length] above which the gain stays below 1/√2 of the static one; None for the heading, a neutral ship and a gain of 0.
    
    transfer: of `transfer_functions`. of: "drift", "yaw" or "heading"."""

def bode(transfer: SwayYawTransfer, of: str, frequencies: ArrayLike, scale: PrimeScale) -> dict:
    """Bode diagram of "drift", "yaw" or "heading" over the rudder at frequencies in radians per ship length: arrays frequency_rad_s, gain, phase [rad, continuous].
    
    transfer: of `transfer_functions`. of: over the rudder. frequencies: one array. scale: length and speed, which give rad/s."""

def captive_error(ship: Ship, points: List[CaptivePoint], selection: CaptiveSelection = ...) -> CaptiveError:
    """How far a ship is off captive tests.
    
    ship: any of a nonlinear model. points: of `read_captive`. selection: which of them count, all unless given."""

def captive_force(ship: Ship, point: CaptivePoint) -> PlanarForce:
    """Force that a captive test would measure of a ship, PlanarForce [N, N m].
    
    ship: any of a nonlinear model. point: motion, controls and acceleration; less what accelerates the entrained water, and less what accelerates the ship herself where that is in the measurement."""

def captive_plan(ship: Ship, points: List[CaptivePoint], terms: str = ..., max_drift: float = ...) -> CaptivePlan:
    """The steps of Alexandersson et al. 2024, table 3, and like ones for yawing, cubic terms and added mass: those whose coefficients the model has and whose tests are among the points (docs/captive_tests.md).
    
    ship: whose coefficients are looked for. points: of `read_captive`. terms: of the hull, "linear" or "cubic". max_drift: of the points that are used [rad]."""

def channels() -> list[Channel]:
    """All channels of recordings, in their order."""

def check(run: Recording) -> RunCheck:
    """Instruments judged by kinematics alone, before any ship is: sign, units, noise, clocks, zeros, scales, axes, lever arm. Raises Refusal for a run of fewer than 20 samples. Source: [Klein2006] chapter 10
    
    run: whose channels are compared with each other."""

def check_groups(checks: List[RunCheck]) -> List[GroupCheck]:
    """Errors that runs with the same instruments have in common, pooled.
    
    checks: of `check`, one for each run. The result has one GroupCheck for each group."""

def coefficient_elasticities(coefficients: SwayYawCoefficients) -> dict:
    """Exact d ln(a1 … c2)/d ln(T1, T2, T3b, T3w, Kb, Kw): a dictionary of dictionaries, NaN where there is none.
    
    coefficients: a1 to c2."""

@overload
def coefficients_from(indices: SteeringIndices) -> SwayYawCoefficients: ...
@overload
def coefficients_from(transfer: SwayYawTransfer) -> SwayYawCoefficients:
    """coefficients_from(*args, **kwargs)
    
    Coupled equations with given indices, the inverse of steering_indices. Infinite or not a number for T3b = T3w. Source: [Artyszuk2016] eqs (29)–(34)
    
    Coupled equations with given transfer functions, the inverse of transfer_functions."""

@overload
def coefficients_of(derivatives: SnameDerivatives, rudder_positive: str = ...) -> SwayYawCoefficients: ...
@overload
def coefficients_of(parts: LinearParts) -> SwayYawSplit:
    """coefficients_of(*args, **kwargs)
    
    Coefficients of the coupled equations, A = M⁻¹F with the signs of v' = -beta. rudder_positive: side to which the rudder angle of the derivatives turns the ship.
    
    derivatives: SnameDerivatives.
    
    Coefficients from hull and rudder, split by what they come from. Source: [Artyszuk2016] eqs (3)–(14)
    
    parts: LinearParts, hull and rudder."""

def compare(ship: Ship, run: Recording, *, window_lengths: float = ...) -> Comparison:
    """Where a simulation and a recording differ: the recorded rudder and shaft speed drive the ship from the recorded state, anew every two ship lengths of way, and once more from the start of the run to its end. Raises Refusal if the run does not tell rudder or speed.
    
    ship, run: that are compared. window_lengths: of a window, in ship lengths of way."""

def compare_verdict(comparisons: List[Comparison]) -> str:
    """One sentence: in which quantity, run, interval and region the ship is farthest off.
    
    comparisons: of `compare`, one for each run."""

def condition_number(coefficients: SwayYawCoefficients) -> float:
    """How much accuracy the conversion between coefficients and indices can lose; infinite where there is none.
    
    coefficients: a1 to c2; the number is that of the matrix [c w] of docs/linear.md."""

def correlation(fit: Regression) -> numpy.ndarray:
    """Correlation of the estimates of a regression, coefficients by coefficients; NaN where one is not determined.
    
    fit: of `regress`."""

def crossover(transfer: SwayYawTransfer, k: float) -> Optional[Crossover]:
    """Crossover of the loop of a helmsman who orders delta = k (psi - wanted); None when the gain is nowhere 1.
    
    transfer: of `transfer_functions`. k: rudder per error of heading."""

def date_text(day: float) -> str:
    """\"2026-03-04", of days since 1970-01-01.
    
    day: with a fraction or without."""

def determined_combinations(sensitivity: List[List[float]], tolerance: List[float]) -> List[IndexCombination]:
    """Combinations of numbers from the best to the worst determined by indices.
    
    sensitivity: d ln index / d ln number, a row for each index. tolerance: relative standard deviation of each index."""

def diagnose(ship: Ship, runs: List[Recording], *, reference: List[Recording] = ..., holdout: List[Recording] = ..., progress: Any = ..., most_effects: int = ..., pictures: bool = ...) -> Diagnosis:
    """What a model left out: where it differs from recordings, which effect explains that, and whether runs that were not used gain by it (docs/diagnose.md).
    
    reference: runs in which nothing is hidden; they calibrate the baseline first. holdout: runs that are not used and say whether the effect is real. progress: a function that is told in words what is going on; False ends the work with what is known. Ctrl-C raises KeyboardInterrupt. Without one a notebook has a line that changes, progress=False nothing. Other threads go on meanwhile. Raises Refusal if there is no run, or one tells neither rudder nor speed.
    
    ship: the model that is doubted. runs: recordings that are to be explained. most_effects: that may be found. pictures: whether the result holds series for figures."""

def diagnose_fleet(ship: Ship, runs: List[FleetRun], *, progress: Any = ..., detection: float = ..., most_changes: int = ...) -> FleetDiagnosis:
    """What sister ships have in common, in what each differs, and what has changed on which of them, by how much and since when (docs/fleet.md).
    
    ship: of the class, with its confidence. runs: of all vessels, each with the key start_utc. progress: a function that is told in words how far it is; False ends the work. detection: gain in log evidence that a change must bring. most_changes: of one vessel. Raises Refusal for a run that does not tell its date, and where no day can be fitted."""

@overload
def dimensional(indices: SteeringIndices, scale: PrimeScale) -> DimensionalIndices: ...
@overload
def dimensional(coefficients: SwayYawCoefficients, scale: PrimeScale) -> DimensionalSwayYaw:
    """dimensional(*args, **kwargs)
    
    With dimension: T = T' L/U, Kr = Kw U/L.
    
    indices: dimensionless. scale: length and speed.
    
    With dimension: the coupled equations for v and r in seconds.
    
    coefficients: dimensionless. scale: length and speed."""

def drift_angle(motion: PlanarMotion) -> float:
    """beta = atan2(-v, u) [rad].
    
    motion: u and v of midship through the water."""

def drift_yaw_loop(coefficients: SwayYawCoefficients, zigzag: LinearZigzag) -> Optional[LoopMeasures]:
    """The loop of the last full cycle of a zigzag; None with fewer than three reversals.
    
    coefficients: of the ship that sailed it. zigzag: of `linear_zigzag` or `limit_cycle`."""

def effect_ids() -> List[str]:
    """Names of all effects, as in ship files."""

def effect_named(id: str) -> Effect:
    """The effect of that name where it does nothing.
    
    id: as in ship files; ValueError for one that is not known."""

def estimate_noise(ship: Ship, runs: List[Recording], *, channels: List[str] = ..., noise: Dict[str, float] = ..., process_noise: Optional[PlanarAcceleration] = ..., coloured: bool = ..., memory: float = ...) -> NoiseEstimate:
    """What is not known of noise and process noise, from several runs at once, for instance calm ones.
    
    ship: the predictor. runs: recordings. channels, noise, process_noise, coloured, memory: as of `estimate_states`, which takes the result: noise=e.noise, process_noise=e.process_noise."""

def estimate_ship(length: float, beam: float, draught: float, block_coefficient: float, service_speed: float, *, trim: float = ..., formula: str = ..., name: str = ..., rudder_area: Optional[float] = ..., propeller_diameter: Optional[float] = ..., resistance: Optional[float] = ...) -> Tuple[Ship, EstimatedShip]:
    """A ship of the MMG model from main dimensions [m], block coefficient and service speed [m/s], and what was assumed. Her confidence is the spread of the formulas and their misses of measured ships. trim: draught aft less draught forward [m]; formula "kijima" takes trim. resistance: R_0'.
    
    length: between perpendiculars. beam, draught: amidships. block_coefficient, service_speed: as told. name: of the ship. rudder_area [m²], propeller_diameter [m]: as estimated unless given. Raises ValueError for dimensions that are not positive."""

def estimate_states(ship: Ship, run: Recording, *, channels: List[str] = ..., noise: Dict[str, float] = ..., process_noise: Optional[PlanarAcceleration] = ..., coloured: bool = ..., memory: float = ..., smooth: bool = ...) -> StateEstimate:
    """States of a recorded ship by an extended Kalman filter with the ship as predictor, and smoother. channels: to be used, all that the run has unless given. noise: known standard deviations by channel, SI; process_noise: known size; what is not known is estimated from the run. memory: of the unmodelled accelerations in ship lengths. Raises Refusal if the run has no rudder angle, or none of the channels tells position or speed.
    
    ship: the predictor. run: to be estimated. coloured: the unmodelled accelerations have a memory and are states; else they are white. smooth: the future of a sample counts too."""

def first_order_drift(indices: SteeringIndices) -> FirstOrder:
    """First-order equation with T_b = T1 + T2 - T3b. Source: [Artyszuk2016] eq. (41)
    
    indices: T1T2, T1_plus_T2, T3b … of `steering_indices`."""

def first_order_yaw(indices: SteeringIndices) -> FirstOrder:
    """First-order equation with T_w = T1 + T2 - T3w. Source: [Artyszuk2016] eq. (42)
    
    indices: T1T2, T1_plus_T2, T3w … of `steering_indices`."""

def fit_captive(ship: Ship, points: List[CaptivePoint], plan: CaptivePlan, *, ridge: float = ...) -> CaptiveFit:
    """Coefficients from captive tests, step by step; standard errors take what earlier steps found for exact. Source: [Alexandersson2024] section 3.1, tables 2, 3
    
    ship: whose other numbers are known. points: of `read_captive`. plan: a CaptivePlan, of `captive_plan` or your own. ridge: shrinks as if so many points had said 0. Raises Refusal if the model lacks a coefficient, its force is not linear in the coefficients of a step, points are both fitted and kept for validation, or a step has too few points."""

def fit_forces(ship: Ship, runs: List[Recording], parameters: Optional[List[str]] = ..., *, channels: List[str] = ..., priors: bool = ..., ridge: float = ...) -> ForceFit:
    """Coefficients that act linearly, by least squares on the forces of inverse dynamics: F(t) - F_known(t) = Σ theta_i ∂F/∂theta_i. parameters: by name, the usual ones unless given. priors: the parameters as given, with the ship's confidence, count as measurements. Source: [Alexandersson2024] section 3.4
    
    ship: whose other numbers are known. runs: recordings. channels: that the estimates of states use, all that a run has unless given. ridge: shrinks as if so many samples had said 0. Raises Refusal if there is nothing to find, a number does not exist or does not act linearly, or a run cannot be estimated."""

def fit_linear(runs: List[Recording], length: float, *, speed: Optional[float] = ..., use_drift: bool = ..., disturbances: bool = ..., rudder_offset: bool = ..., spacing: float = ...) -> LinearFit:
    """Both second-order equations fitted to recordings of any ship of that length [m], stable or not: maximum likelihood of the one-step prediction errors of a Kalman filter. speed [m/s]: constant, else as recorded. spacing: least distance of the measurements used, ship lengths.
    
    runs: recordings. use_drift: drift counts where it was recorded. disturbances: random forces act on the ship, else only the measurements are noisy. rudder_offset: the recorded rudder angle has an unknown zero. Raises Refusal if a run tells neither heading nor yaw rate, or has fewer than 20 measurements."""

def fit_trajectories(ship: Ship, runs: List[Recording], parameters: Optional[List[str]] = ..., *, channels: List[str] = ..., noise: Dict[str, float] = ..., priors: bool = ..., robust: Optional[float] = ..., segment: float = ..., most_iterations: int = ..., threads: int = ..., progress: Any = ...) -> TrajectoryFit:
    """Parameters of a ship fitted to recordings by multiple shooting, maximum likelihood of white measurement noise, with exact derivatives (docs/trajectory_fit.md).
    
    progress: a function of iteration, log likelihood, relative change and a dictionary of the parameters (SI); False ends the fit with the best so far. Ctrl-C raises KeyboardInterrupt. Without one a notebook has a line that changes, progress=False nothing. threads: 0 for one on each core.
    
    ship: where the fit begins. runs: recordings, each with a start that is fitted too. parameters: by name, the usual ones unless given. channels: to fit to, all that a run has unless given. noise: known standard deviations by channel, SI, else estimated. priors: the parameters as given, with the ship's confidence, count as measurements. robust: residuals beyond so many standard deviations count with their size, 1.345. segment: length of the segments [ship lengths]. most_iterations: at most.
    
    Raises Refusal if there is nothing to fit or to fit to, or the ship cannot be simulated; ValueError for a noise or segment that is not positive."""

def force_breakdown(ship: Ship, state: ShipState, controls: Controls) -> ForceBreakdown:
    """Which force acts here, and from which part? The rudder angle is that of the rudder. Raises Refusal if no force model holds for the motion or the controls.
    
    ship: of any nonlinear model. state: where she is and how she moves. controls: rudder angle and shaft speed or thrust. Forces are in N, moments about midship in N m."""

def frame_of(records) -> Any:
    """Values of one type, such as `diagnosis.candidates` or `zigzag.reversals`, as a pandas.DataFrame: a row for each, a
    column for each field.
    
    records: a list of values of one type."""

def has_kink(ship: Ship, point: OperatingPoint) -> bool:
    """Whether the derivatives of turns to port and to starboard differ there.
    
    ship: of any nonlinear model. point: of `straight_course` or of a steady turn."""

def imo_criteria(ship: Ship, *, speed: Optional[float] = ..., rev: Optional[float] = ..., thrust: Optional[float] = ...) -> ImoCriteria:
    """Turning circle and the zigzags 10/10 and 20/20, to both sides, judged by MSC.137(76); speed [m/s].
    
    ship: of any nonlinear model. speed: of the approach, the service speed unless given. rev: shaft speed [1/s], or thrust: of all propellers [N]; self-propulsion unless given. Raises Refusal if she cannot propel herself at the speed."""

def import_mat(file: Union[str, 'PathLike[str]'], columns: Union[str, 'PathLike[str]'] = ...) -> Import:
    """A MATLAB file, versions 4 to 7.3, as a recording.
    
    file: to be read. columns: a column map, where the names of the file are not clear. Raises FileError for what stays open."""

def import_nmea(files: List[Union[str, 'PathLike[str]']], columns: Union[str, 'PathLike[str]'] = ...) -> Import:
    """Logs of NMEA 0183 sentences as one recording.
    
    files: in the order of time. columns: a column map (docs/import.md). Raises FileError for what stays open."""

def import_table(files: List[Union[str, 'PathLike[str]']], columns: Union[str, 'PathLike[str]'] = ...) -> Import:
    """Text tables of spreadsheets and loggers as one recording; `columns` is a column map (docs/import.md). Nothing is guessed silently: what stays open is refused with the line of the map that settles it.
    
    files: in the order of time; FileError names file and line of what is refused."""

def in_model(ship: Ship, model: str) -> Ship:
    """The ship in another model, "mmg", "pi" or "pu", with the same hull, propeller and steering gear.
    
    ship: of a nonlinear model. model: its name. Raises Refusal where the other model needs numbers that she does not have."""

def index_sensitivity(ship: Ship, measured: MeasuredIndices, parameters: List[str] = ...) -> IndexSensitivity:
    """What numbers of a ship do to the indices that were measured.
    
    measured: the manoeuvres and indices. parameters: columns of the result, those of `tuned_parameters`. Raises Refusal as `tune` does."""

def instability_loop(curve: List[SteadyTurn]) -> Optional[InstabilityLoop]:
    """Hysteresis of a curve of steady turns; None where there is one turn at every rudder angle.
    
    curve: of `steady_turn_curve`, in its order."""

def inverse_distance(indices: SteeringIndices) -> float:
    """|T3b - T3w|/(|T3b| + |T3w|), 0 where no inverse exists.
    
    indices: whose T3b and T3w are looked at."""

def inverse_dynamics(ship: Ship, run: Recording, estimate: StateEstimate) -> List[InverseDynamics]:
    """Forces at each sample of an estimated run, from its motion and what pushed it: damping = M (a + d) less centrifugal and Coriolis terms and wind (docs/state_estimation.md). Source: [Alexandersson2024] eqs (1)-(3), (39)-(41)
    
    ship: she whom it was estimated with. run: as recorded. estimate: of `estimate_states`. Raises Refusal if the run has no rudder angle, or another number of samples than the estimate."""

def largest_file(use: str = ...) -> int:
    """Bytes of the largest file that is read now; a larger one raises FileError.
    
    use: "samples", of recordings, logs and tables; "description", of ships and measured indices."""

def limit_cycle(coefficients: SwayYawCoefficients, rudder: float, heading: float, rate: float, first: str = ...) -> LimitCycle:
    """The zigzag sailed until it repeats.
    
    coefficients: of the ship. rudder, heading [rad]; rate: of the rudder in rad per ship length. first: side turned to first."""

def linear_ship(ship: Ship, linearization: Linearization) -> LinearShip:
    """The ship in small motions about the operating point, in the form that the linear floor works with.
    
    ship: she who was linearized. linearization: of `linearize`."""

def linear_view(model: Ship, runs: List[Recording]) -> List[LinearView]:
    """Each zigzag among runs beside a ship's replay of it, by K, T and the drift-yaw loop.
    
    model: who replays. runs: those that are no zigzags, or that she cannot sail, are left out."""

def linear_words(views: List[LinearView]) -> str:
    """What follows from zigzags: offset, gain, history, in words; empty where recordings and model agree within a tenth.
    
    views: of `linear_view`."""

def linear_zigzag(coefficients: SwayYawCoefficients, rudder: float, heading: float, rate: float, first: str = ..., reversals: int = ...) -> LinearZigzag:
    """The zigzag from straight ahead, exact: every leg a closed form, every switch the root of one. Rudder and heading [rad]; rate in rad per ship length, infinite for a step.
    
    coefficients: of the ship. rudder, heading, rate: positive. first: side turned to first. reversals: how many to sail for. Raises ValueError for an angle or a rate that is not positive."""

def linear_zigzag_batch(coefficients: SwayYawCoefficients, values: Dict[str, ArrayLike], rudder: float, heading: float, rate: float, first: str = ..., reversals: int = ..., *, threads: int = ..., instruction_set: str = ...) -> LinearZigzagBatch:
    """The zigzag of many linear ships, switches as `linear_zigzag` gives them to 1e-10.
    
    coefficients: of all ships but for `values`: arrays by name, a1 to c2, one value for each ship. rudder, heading [rad]; rate in rad per ship length. first: side turned to first. reversals: 16 at most. threads: 0 for one on each core. instruction_set: best, numbers, baseline, avx2 or avx512.
    
    Raises ValueError if lengths differ, an angle or the rate is not positive, or the instruction set is not there."""

def linearize(ship: Ship, point: OperatingPoint, side: Optional[str] = ...) -> Linearization:
    """Linear motion about a steady motion. Where the forces have a kink, as the MMG rudder has straight ahead, the derivatives are those of a turn to `side`, or without a side the mean of both. Raises Refusal if the ship does not move ahead, or accelerates there by more than 1e-6 U²/L.
    
    ship: of any nonlinear model. point: of `straight_course`, or an OperatingPoint of a steady turn."""

def linearize_transient(ship: Ship, point: OperatingPoint, side: Optional[str] = ...) -> Linearization:
    """The same about a motion that need not be steady: the derivatives hold while the motion is near it.
    
    ship: of any nonlinear model. point: an OperatingPoint. side: of the derivatives at a kink, else the mean of both."""

def load_ship(ship: Union[str, 'PathLike[str]']) -> Union[Ship, LinearShip]:
    """A ship of any model, nonlinear (Ship) or linear (LinearShip).
    
    ship: a ship file, or where no such file is there, the bare name of a published ship. Raises FileError
    "FILE:LINE:COLUMN: what is wrong", Refusal for a name that is not published."""

def loop_sensitivity(indices: SteeringIndices, rudder: float, heading: float, rate: float, first: str = ...) -> Optional[LoopSensitivity]:
    """Exact derivatives of loop and overshoots by T3b and T3w. Raises ValueError if T3b = T3w.
    
    indices: of the ship. rudder, heading [rad]; rate: of the rudder in rad per ship length. first: side turned to first."""

def manoeuvres_in(run: Recording) -> List[ManoeuvrePiece]:
    """What is sailed in a long recording, in order of time, found by rudder and heading.
    
    run: a recording of hours. Each ManoeuvrePiece has begin and end [s] and what was sailed."""

def map_fit(ship: Ship, runs: List[Recording], unknowns: List[Unknown], ship_in: Callable[..., Any], *, channels: List[str] = ..., noise: Noise = ..., lean: bool = ..., rounds: int = ...) -> MapFit:
    """Unknowns of any kind estimated together from recorded runs: the maximum of their posterior under a Kalman filter
    that carries what no model gets right, and its evidence (docs/estimation.md).
    
    ship: whose length and speed give units of noise. unknowns: a list of Unknown. ship_in: a function of their values, by
    name, and the place of a run, that gives the ship who sailed it; Refusal from it means that no ship can sail like that,
    any other exception ends the fit, and so does Ctrl-C. channels: to be compared, all that show the motion unless given.
    noise: where the search for it begins. lean: as few samples as tell what they tell. rounds: of gains and noise.
    
    Raises Refusal if a run tells neither rudder nor speed, ValueError for a deviation that is not positive."""

def measured_indices(length: float, *, turns: Sequence[Mapping[str, Any]] = ..., zigzags: Sequence[Mapping[str, Any]] = ..., speed: Optional[float] = ..., rev: Optional[float] = ..., thrust: Optional[float] = ..., tolerance: Optional[float] = ...) -> MeasuredIndices:
    """Measured indices from dictionaries with the keys of an index file (docs/formats.md):
    
    measured_indices(56.85, speed=5.91, turns=[{"rudder_deg": 35, "advance_L": 2.2, "final_diameter_L": 1.2}],
                     zigzags=[{"rudder_deg": 10, "heading_deg": 20, "overshoot_deg": [15, 19]}])
    
    length: of the ship [m], for lengths in it. turns, zigzags: one dictionary for each manoeuvre; {"value": 2.2, "sd":
    0.1} tells a deviation. speed: of the approach [m/s]. rev: shaft speed [1/s], or thrust: of all propellers [N].
    tolerance: relative standard deviation of what has none, 0.05 unless given. Raises FileError "measured
    indices:LINE:COLUMN: what is wrong" with the line of the text that they make."""

def measured_samples(run: Recording, channel: str) -> List[int]:
    """Places of the samples of a channel that were really measured.
    
    run: a recording, perhaps of a logger that repeats old values. channel: by its short name."""

def missing_force(ship: Ship, run: Recording, noise: Noise = ...) -> List[MissingForce]:
    """The force that drives a recorded ship beyond her model, by a Kalman filter and smoother that carry an acceleration with a memory of L/U: a list of MissingForce, one for each sample.
    
    ship: the model. run: tells rudder and speed, else Refusal. noise: a Noise; its scale is the deviation of that acceleration over that of an adequate model."""

def nomoto_zigzag(run: Recording) -> NomotoZigzag:
    """Nomoto's analysis of a recorded zigzag. Raises Refusal with fewer than three heading peaks.
    
    run: heading and rudder suffice."""

def ordinary_force(ship: Ship) -> PlanarForce:
    """Standard deviation of the force that an adequate model leaves out [N, N, N m].
    
    ship: of any nonlinear model."""

def parse_csv(text: str, name: Union[str, 'PathLike[str]'] = ..., rudder_positive: Optional[str] = ...) -> Recording:
    """A recording from text as `read_csv` reads it.
    
    text: of a recording file. name: stands for the file in messages. rudder_positive: side to which the rudder column is
    positive, whatever the text says. Raises FileError "NAME:LINE:COLUMN: what is wrong"."""

def parse_indices(text: str, length: float, name: Union[str, 'PathLike[str]'] = ...) -> MeasuredIndices:
    """Measured indices from the text of such a file.
    
    length: of the ship [m]. name: stands for the file in messages. Raises FileError "NAME:LINE:COLUMN: what is wrong"."""

def parse_linear_ship(text: str, name: Union[str, 'PathLike[str]'] = ...) -> LinearShip:
    """A linear ship from the text of a ship file; `name` stands for the file in messages.
    
    text: of a ship file. name: of the file. Raises FileError "NAME:LINE:COLUMN: what is wrong"."""

def parse_ship(text: str, name: Union[str, 'PathLike[str]'] = ...) -> Ship:
    """A ship of a nonlinear model from the text of a ship file; `name` stands for the file in messages.
    
    text: of a ship file. name: of the file. Raises FileError "NAME:LINE:COLUMN: what is wrong"."""

def part_elasticities(coefficients: SwayYawCoefficients, ship: LinearParts, known: str) -> dict:
    """The same of hull and rudder, by the indices and the known number.
    
    coefficients: given. ship: LinearParts, whose other numbers stay. known: the known number."""

def parts_from(coefficients: SwayYawCoefficients, ship: LinearParts, known: str) -> LinearParts:
    """Hull and rudder that have given coefficients. c1 gives a_H, c2/c1 gives x_Reff; the known number, one of Y_b, Y_w, N_b, N_w, c_Ry, closes a1, b1, a2, b2 for the other four. Source: [Artyszuk2016] eqs (44)–(46)
    
    coefficients: given. ship: LinearParts, whose other numbers stay. known: the number that is known. Raises Refusal where no hull has them."""

def piece_of(run: Recording, piece: ManoeuvrePiece) -> Recording:
    """The piece as a recording of its own: time from 0 at its first sample.
    
    run: a recording. piece: of `manoeuvres_in`."""

def pooled_errors(comparisons: List[Comparison]) -> List[QuantityError]:
    """Errors of each quantity in all runs together.
    
    comparisons: of `compare`, one for each run. The result has a QuantityError for each quantity."""

def process_noise(ship: Ship, noise: Noise = ...) -> PlanarAcceleration:
    """Standard deviation of the accelerations that a model leaves out, PlanarAcceleration: 0.002 U²/L times the scale in sway, 0.3 of that in surge, 1.5/L of that in yaw.
    
    ship: whose length and service speed count. noise: its scale and axes."""

def published_ship(name: str) -> Ship:
    """The published ship of a nonlinear model with that name. Raises Refusal that lists the names.
    
    name: of `published_ships`, "kvlcc2"."""

def published_ships() -> List[str]:
    """Names of all published ships, linear ones among them."""

def published_text(name: str) -> str:
    """The ship file of that name.
    
    name: of `published_ships`; Refusal for another."""

def pull_out(ship: Ship, rudder: float, *, speed: Optional[float] = ..., rev: Optional[float] = ..., thrust: Optional[float] = ..., duration: Optional[float] = ..., step: Optional[float] = ..., tolerance: float = ..., sampled: bool = ...) -> PullOut:
    """Turns with the rudder [rad] held, then puts it amidships, to both sides; both motions last until they are steady. `duration` is not used. Source: [MSC/Circ.1053] appendix 4.
    
    speed: of the approach [m/s], the service speed unless given. rev: shaft speed [1/s], or thrust: of all propellers [N]; self-propulsion at that speed unless given. duration [s]: else until the indices are known. step: between samples [s]. sampled=False keeps no time series and is faster.
    
    Raises ValueError for an angle that is not positive or beyond the ship's largest, Refusal if she cannot propel herself at the speed.
    
    tolerance: error of an integration step."""

def read_captive(file: Union[str, 'PathLike[str]'], length: float, *, density: float = ..., towed_length: Optional[float] = ..., towed_density: Optional[float] = ..., test: str = ..., thrust_prime: Optional[float] = ...) -> List[CaptivePoint]:
    """Points of captive tests from a table with a header, units in the names of its columns (docs/captive_tests.md).
    
    length: of the ship [m]; density: of her water [kg/m³]. towed_length, towed_density: of the model in the tank, where it was another. test: kind of all tests, where the file does not say. thrust_prime: T/(½ρL²U²), likewise. Raises FileError that names the column that is missing, or the cell that is no number."""

def read_csv(file: Union[str, 'PathLike[str]'], rudder_positive: Optional[str] = ...) -> Recording:
    """A recording from a file of comma-separated text (docs/formats.md), as every command of the program reads it.
    
    All units become SI, the rudder positive to port, latitude and longitude a plane about the first fix, position and
    velocity those of midship. What the reader should be told is warned of.
    
    rudder_positive: "port" or "starboard", the side to which the rudder column is positive, whatever the file says.
    Raises FileError "FILE:LINE:COLUMN: what is wrong"."""

def read_indices(file: Union[str, 'PathLike[str]'], length: float) -> MeasuredIndices:
    """Measured indices of turning circles and zigzags from a file (docs/formats.md).
    
    length: of the ship [m], for lengths that the file gives in it. Raises FileError "FILE:LINE:COLUMN: what is wrong"."""

def read_linear_ship(file: Union[str, 'PathLike[str]']) -> LinearShip:
    """A linear ship from a ship file.
    
    file: of the model "linear". Raises FileError "FILE:LINE:COLUMN: what is wrong"."""

def read_ship(file: Union[str, 'PathLike[str]']) -> Ship:
    """A ship of a nonlinear model from a ship file. Raises FileError "FILE:LINE:COLUMN: what is wrong".
    
    file: of one of the models mmg, pi, pu and abkowitz."""

def recorded_overshoots(run: Recording, order: ZigzagOrder) -> List[float]:
    """Heading peaks beyond the switch angle in a recorded zigzag as they come [rad].
    
    run: as recorded. order: a ZigzagOrder, of `zigzag_order`."""

def recorded_state(ship: Ship, run: Recording, time: float) -> ShipState:
    """Recorded state of the ship through the water at a time [s].
    
    ship: whose instruments and length count. run: a recording. time: within it. Raises Refusal if the run does not tell rudder or speed."""

def regress(X: ArrayLike, y: ArrayLike, names: Optional[List[str]] = ..., *, runs: List[int] = ..., variance: Optional[ArrayLike] = ..., variance_known: bool = ..., residuals: str = ..., order: int = ..., standard_errors: str = ..., ridge: float = ..., priors: Dict[str, Tuple[float, float]] = ..., constraints: List[Tuple[List[Tuple[str, float]], float]] = ..., feature_covariance: Optional[ArrayLike] = ..., feature_size_known: bool = ...) -> Regression:
    """Linear regression y = X b + e for forces: what data tell of each coefficient, and what they do not
    (docs/identification.md).
    
    X: features, samples by coefficients. y: what is explained. names: of the coefficients, b0, b1 … unless given. runs:
    first row of each run, where there are several; the rows of a run follow each other in equal steps of time. variance: of
    each y, up to a common factor; variance_known: they are the true ones. residuals: "independent", or "autoregressive" of
    that `order` within a run. standard_errors: "of_model" or "newey_west". ridge: shrinks as if so many samples had said 0.
    priors: {name: (mean, deviation)}. constraints: [([(name, weight), …], sum), …], held exactly. feature_covariance: of
    the errors in (x, y), p + 1 by p + 1, one for all samples or one for each; feature_size_known=False takes it up to a
    factor: total least squares. Source: [Prais1954], [Newey1994], [Andrews1992], [Fuller1987]
    
    Raises Refusal if a name is not known, a number is not finite, constraints contradict each other or there are no more
    samples than coefficients; ValueError if sizes do not fit or a variance or deviation is not positive."""

def remark_of(run: Recording, key: str) -> str:
    """The text of a run key that the samples do not hang on, without quotes; empty if the run has none.
    
    run: a recording. key: as above the columns of its file, "vessel"."""

def repaired(run: Recording, check: RunCheck) -> Recording:
    """The run without the errors that were told, and without outliers.
    
    run: that was checked. check: of `check`."""

def replay(ship: Ship, run: Recording, *, shaft: str = ..., tolerance: float = ...) -> Recording:
    """The whole run simulated from its recorded start with the recorded rudder and shaft speed, sampled at the recorded times, in the wind and depth that were measured. shaft="self_propulsion": with what carries the model at the recorded starting speed. Raises Refusal if the run does not tell rudder or speed.
    
    ship: who sails. run: a recording. shaft: "recorded" or "self_propulsion". tolerance: error of an integration step."""

def resample(ship: Ship, runs: List[Recording], fit: ForceFit, parameters: Optional[List[str]] = ..., *, priors: bool = ..., ridge: float = ...) -> List[Resample]:
    """How much coefficients depend on the choice of runs: from all runs, without each, from each alone, and from each rudder amplitude alone.
    
    ship, runs, parameters, priors, ridge: as `fit_forces` was given them. fit: its result, whose states are taken."""

def response(coefficients: SwayYawCoefficients, rudder: RudderHistory, s: ArrayLike, start: LinearState = ...) -> dict:
    """Exact response to a rudder history at dimensionless times s' = tU/L: arrays beta [rad], omega', psi [rad].
    
    coefficients: of the ship. rudder: of `rudder_step` or `rudder_ramp_and_hold`. s: times, an array. start: at s' = 0, straight ahead unless given."""

def reverse_spiral(ship: Ship, largest: float = ..., steps: int = ..., *, speed: Optional[float] = ..., rev: Optional[float] = ..., thrust: Optional[float] = ...) -> ReverseSpiral:
    """For each yaw rate the mean rudder angle of a helmsman who keeps it, up to `largest` [rad].
    
    ship: of any nonlinear model. steps: between yaw rate 0 and the largest. speed: of the approach [m/s], the service speed unless given. rev: shaft speed [1/s], or thrust: of all propellers [N]."""

def rudder_ramp_and_hold(angle: float, rate: float) -> RudderHistory:
    """From midships to `angle` [rad] at `rate` [rad per ship length], then held.
    
    angle: positive to port. rate: positive. For `response`."""

def rudder_step(angle: float) -> RudderHistory:
    """The rudder is at `angle` [rad] from s' = 0.
    
    angle: positive to port. For `response`."""

def run_picture(given: Ship, refitted: Ship, after: Ship, run: Recording, noise: Noise = ...) -> RunPicture:
    """A run beside replays and missing forces of three ships, at most 500 points.
    
    given: the ship as she was given. refitted: with other coefficients. after: with effects. run: as recorded. noise: one for all, so that what shrinks is the force and not the allowance for it."""

def selected(points: List[CaptivePoint], selection: CaptiveSelection) -> List[CaptivePoint]:
    """Those of captive points that a selection takes.
    
    points: of `read_captive`. selection: a CaptiveSelection."""

def self_propulsion(ship: Ship, speed: Optional[float] = ...) -> Controls:
    """Rudder amidships and the shaft speed, or thrust, that carries her straight ahead at that speed [m/s]. What of her effects drags on her all the time, on every heading, is carried, too.
    
    ship: of any nonlinear model. speed: the service speed unless given. Raises Refusal if she cannot propel herself at it."""

def set_largest_file(bytes: int) -> None:
    """From now on the largest file that is read has so many bytes, whatever its use. 0: the usual sizes.
    
    bytes: 4_000_000_000 is what `--max-file-size 4GB` is to the program."""

def simulated_overshoots(ship: Ship, run: Recording, order: ZigzagOrder, most: int) -> Optional[List[float]]:
    """Overshoots of a ship in the zigzag of a run, from its recorded speed with its mean shaft speed or thrust [rad].
    
    ship: who sails. run, order: the recorded zigzag. most: how many overshoots. None where she cannot sail it."""

def sname_derivatives(coefficients: SwayYawCoefficients, inertia: SnameDerivatives, rudder_positive: str = ...) -> SnameDerivatives:
    """The derivatives that give the coefficients, with mass, inertia and added masses as in `inertia`; F = M A.
    
    coefficients: a1 to c2. inertia: SnameDerivatives. rudder_positive: side to which the rudder angle of the derivatives turns the ship."""

def speed(motion: PlanarMotion) -> float:
    """U = sqrt(u² + v²) [m/s].
    
    motion: u and v of midship [m/s]."""

def spiral(ship: Ship, largest: float = ..., step_angle: float = ..., first: str = ..., *, speed: Optional[float] = ..., rev: Optional[float] = ..., thrust: Optional[float] = ..., duration: Optional[float] = ..., step: Optional[float] = ..., tolerance: float = ..., sampled: bool = ...) -> Spiral:
    """Dieudonné's spiral: the rudder goes from the largest angle [rad] on one side to that on the other and back in steps of `step_angle` [rad], held at each until the ship turns steadily. `duration` is not used.
    
    speed: of the approach [m/s], the service speed unless given. rev: shaft speed [1/s], or thrust: of all propellers [N]; self-propulsion at that speed unless given. duration [s]: else until the indices are known. step: between samples [s]. sampled=False keeps no time series and is faster.
    
    Raises ValueError for an angle that is not positive or beyond the ship's largest, Refusal if she cannot propel herself at the speed.
    
    first: side of the first angle. tolerance: error of an integration step."""

def start_utc(run: Recording) -> Optional[float]:
    """Seconds since 1970 UTC at which the time of a run is 0, by its key start_utc; None where it has none.
    
    run: a recording."""

def steady_motion(ship: Ship, controls: Controls, guess: PlanarMotion) -> Optional[SteadyMotion]:
    """The steady motion that Newton's method finds from the guess at constant controls; None where it does not.
    
    ship: of any nonlinear model. controls: rudder angle and shaft speed or thrust. guess: where the search begins."""

def steady_run_in_wind(ship: Ship, wind_speed: float, wind_from: float, direction: float = ..., kept: str = ...) -> Optional[WindRun]:
    """The straight run in a true wind [m/s] from a direction [rad, clockwise from north] that keeps the course or the heading `direction` [rad]; None where no helm balances that wind.
    
    ship: of any nonlinear model. wind_speed, wind_from: the true wind. kept: "course" or "heading"."""

def steady_turn_curve(ship: Ship, largest: float, *, speed: Optional[float] = ...) -> List[SteadyTurn]:
    """The r-delta curve through all its folds, up to that rudder angle [rad] on both sides, with the propulsion of that straight speed [m/s].
    
    ship: of any nonlinear model. largest: rudder angle. speed: the service speed unless given."""

@overload
def steering_indices(coefficients: SwayYawCoefficients) -> SteeringIndices: ...
@overload
def steering_indices(transfer: SwayYawTransfer) -> SteeringIndices:
    """steering_indices(*args, **kwargs)
    
    Steering indices of the coupled equations. Source: [Artyszuk2016] eqs (17)–(24). Infinite or not a number for a neutral ship, or where Kb or Kw is 0.
    
    coefficients: a1 to c2.
    
    Steering indices of transfer functions.
    
    transfer: of `transfer_functions`."""

def straight_course(ship: Ship, speed: Optional[float] = ...) -> OperatingPoint:
    """Straight ahead at that speed [m/s], the service speed unless given, with self-propulsion.
    
    ship: of any nonlinear model. speed: straight ahead. Raises Refusal if she cannot propel herself at it."""

def sweep(plan: Union[str, 'PathLike[str]'], out: Union[str, 'PathLike[str]'], client=..., progress: Optional[Callable[[int, int], object]] = ...) -> SweepStore:
    """Works on what is not there yet of a sweep, and returns its results.
    
    plan: file of the plan (TOML), which all workers can read, the ship files beside it too. out: folder of the results,
    the same as of `swayaw sweep --out`: program and module go on where the other was, and end with the same numbers.
    client: of dask.distributed; without one all cores of this machine work. progress: is told how many blocks are there,
    of how many, after each task. Raises FileError for a mistake in the plan, Refusal for recordings, which the program
    works on, and for a folder with other results."""

def t3_map(indices: SteeringIndices, rudder: float, heading: float, rate: float, T3b: ArrayLike, T3w: ArrayLike, *, threads: int = ...) -> T3Map:
    """Loop measures of the limit cycle for every pair of T3b and T3w, the other indices held.
    
    indices: of the ship. rudder, heading [rad]; rate in rad per ship length. T3b, T3w: arrays of the map. threads: 0 for one on each core. Raises ValueError if T1 T2, Kb or Kw is 0, or an angle or the rate is not positive."""

def tells_propulsion(ship: Ship, run: Recording) -> bool:
    """Whether a run tells what propels the ship: her shaft speed, where her model takes one, or a thrust. The polynomial of an Abkowitz ship holds her propulsion.
    
    ship: who sails. run: a recording."""

@overload
def time_constants(transfer: SwayYawTransfer) -> Optional[TimeConstants]: ...
@overload
def time_constants(coefficients: SwayYawCoefficients) -> Optional[TimeConstants]:
    """time_constants(*args, **kwargs)
    
    T1 and T2; None when they are a complex pair.
    
    transfer: of `transfer_functions`; dimensionless.
    
    T1 and T2; None when they are a complex pair.
    
    coefficients: a1 to c2; dimensionless."""

@overload
def to_prime(indices: DimensionalIndices, scale: PrimeScale) -> SteeringIndices: ...
@overload
def to_prime(equations: DimensionalSwayYaw, scale: PrimeScale) -> SwayYawCoefficients:
    """to_prime(*args, **kwargs)
    
    The inverse of dimensional.
    
    indices: with dimension. scale: length and speed.
    
    The inverse of dimensional.
    
    equations: with dimension. scale: length and speed."""

@overload
def transfer_functions(coefficients: SwayYawCoefficients) -> SwayYawTransfer: ...
@overload
def transfer_functions(indices: SteeringIndices) -> SwayYawTransfer:
    """transfer_functions(*args, **kwargs)
    
    Transfer functions of the coupled equations.
    
    coefficients: a1 to c2.
    
    Transfer functions with given indices.
    
    indices: of `steering_indices`."""

def trial(run: Recording, ship: Optional[Ship] = ..., *, length: Optional[float] = ..., speed: Optional[float] = ...) -> TrialResult:
    """A recorded manoeuvre judged: overshoots, K and T, turning circle, criteria of MSC.137(76), with standard errors. Heading and rudder suffice. The ship gives her length [m] and largest rudder angle; speed: of the approach [m/s], in place of the recorded one. Raises Refusal where the run tells no manoeuvre.
    
    run: the recording. ship: of any nonlinear model; without her, length: of the ship [m]."""

def trial_summary(trials: List[TrialResult]) -> ImoSummary:
    """One verdict of several trials by MSC.137(76).
    
    trials: of `trial`, one for each run."""

def tune(ship: Ship, measured: MeasuredIndices, parameters: List[str] = ..., *, prior: Optional[float] = ..., most_change: Optional[float] = ..., most_turns: int = ..., least_decay: float = ..., progress: Any = ...) -> Tuning:
    """Coefficients of a ship from measured indices of her manoeuvres: weighted least squares with a prior and exact
    derivatives (docs/index_tuning.md). Source: [Kulbiej2021] section 4
    
    measured: of `read_indices`. parameters: that may change, by name; unless given those of the hull that are not 0, but
    for its resistance. prior: relative standard deviation of each number; that of the ship's confidence unless given.
    most_change: largest relative change. most_turns: turning circles to be sailed at most. least_decay: what a steady turn
    must keep, decay of a disturbance per ship length. progress: a function of the manoeuvres sailed (SimulationCount) and
    the error of the best ship so far (TuningError); False ends the tuning with her, Ctrl-C raises KeyboardInterrupt.
    Without one a notebook has a line that changes, progress=False nothing.
    
    Raises Refusal for a ship in wind, one that does not reach a measured index to begin with or lacks a parameter, or where
    a number to change is 0; ValueError if an option is not positive or a rudder angle beyond the ship's largest."""

def tuned_parameters(ship: Ship, parameters: List[str] = ...) -> List[Parameter]:
    """The numbers that `tune` changes, as Parameter.
    
    parameters: by name; unless given those of the hull that are not 0, but for its resistance. Raises Refusal for one that she does not have.
    
    ship: who is tuned."""

def turning_circle(ship: Ship, rudder: float, side: str = ..., *, speed: Optional[float] = ..., rev: Optional[float] = ..., thrust: Optional[float] = ..., duration: Optional[float] = ..., step: Optional[float] = ..., tolerance: float = ..., sampled: bool = ...) -> TurningCircle:
    """Turning circle with the rudder [rad] held over to a side. Ends after 540 deg, or where the ship no longer moves ahead, unless a duration is given.
    
    speed: of the approach [m/s], the service speed unless given. rev: shaft speed [1/s], or thrust: of all propellers [N]; self-propulsion at that speed unless given. duration [s]: else until the indices are known. step: between samples [s]. sampled=False keeps no time series and is faster.
    
    Raises ValueError for an angle that is not positive or beyond the ship's largest, Refusal if she cannot propel herself at the speed.
    
    tolerance: error of an integration step."""

def turning_circle_slopes(ship: Ship, rudder: float, parameters: List[str], side: str = ..., *, speed: Optional[float] = ...) -> dict:
    """The same of a turning circle, told as of a turn to starboard.
    
    ship: of any nonlinear model. rudder: angle [rad], positive. parameters: by name. side: turned to. speed: of the approach [m/s], the service speed unless given."""

def usual_parameters(ship: Ship) -> List[str]:
    """Coefficients that are looked for unless others are named.
    
    ship: those of her hull that are not 0, and of a PU ship those of the rudder."""

def williamson_turn(ship: Ship, rudder: float = ..., heading: float = ..., before: float = ..., first: str = ..., *, speed: Optional[float] = ..., rev: Optional[float] = ..., thrust: Optional[float] = ..., duration: Optional[float] = ..., step: Optional[float] = ..., tolerance: float = ..., sampled: bool = ...) -> WilliamsonTurn:
    """Rudder [rad] hard over to `first` until the heading has changed by `heading` [rad], to the other side until it is `before` [rad] short of the reciprocal, then amidships. Source: [IAMSAR].
    
    speed: of the approach [m/s], the service speed unless given. rev: shaft speed [1/s], or thrust: of all propellers [N]; self-propulsion at that speed unless given. duration [s]: else until the indices are known. step: between samples [s]. sampled=False keeps no time series and is faster.
    
    Raises ValueError for an angle that is not positive or beyond the ship's largest, Refusal if she cannot propel herself at the speed.
    
    rudder, heading, before: angles, positive. tolerance: error of an integration step."""

def with_followed_order(run: Recording, gear: SteeringGear) -> Recording:
    """A run that tells the ordered rudder angle alone, with that of a rudder that follows it, as fit_linear needs; any other run as it is.
    
    run: a recording. gear: SteeringGear."""

def with_forces(run: Recording, ship: Ship) -> Recording:
    """The run with forces by part as extra columns X_hull_N, Y_hull_N, N_hull_N_m, …
    
    ship: of any nonlinear model. run: a recording; Refusal if it does not tell rudder or speed."""

def without_outliers(run: Recording) -> Recording:
    """The run with outliers of the channels that show the motion missing.
    
    run: a recording, perhaps with wrong fixes of the satellites."""

def writable(found: Ship, beginning: Ship) -> Tuple[Ship, List[str]]:
    """The ship as a file can hold her, and what had to give way for that, in words.
    
    found: as a fit left her. beginning: she whom the fit began with."""

def zigzag(ship: Ship, rudder: float, heading: float, first: str = ..., *, speed: Optional[float] = ..., rev: Optional[float] = ..., thrust: Optional[float] = ..., duration: Optional[float] = ..., step: Optional[float] = ..., tolerance: float = ..., sampled: bool = ...) -> Zigzag:
    """Zigzag: the rudder [rad] is put over to the side `first`; whenever the heading has changed by `heading` [rad] to the side of the turn it is reversed. Ends after the fourth overshoot unless a duration is given.
    
    speed: of the approach [m/s], the service speed unless given. rev: shaft speed [1/s], or thrust: of all propellers [N]; self-propulsion at that speed unless given. duration [s]: else until the indices are known. step: between samples [s]. sampled=False keeps no time series and is faster.
    
    Raises ValueError for an angle that is not positive or beyond the ship's largest, Refusal if she cannot propel herself at the speed.
    
    tolerance: error of an integration step."""

@overload
def zigzag_batch(ships: List[Ship], rudder: float, heading: float, first: str = ..., *, reversals: int = ..., speed: Optional[float] = ..., rev: Optional[float] = ..., duration: Optional[float] = ..., tolerance: float = ..., threads: int = ..., instruction_set: str = ...) -> ZigzagBatch: ...
@overload
def zigzag_batch(ship: Ship, values: Dict[str, ArrayLike], rudder: float, heading: float, first: str = ..., *, reversals: int = ..., speed: Optional[float] = ..., rev: Optional[float] = ..., duration: Optional[float] = ..., tolerance: float = ..., threads: int = ..., instruction_set: str = ...) -> ZigzagBatch:
    """zigzag_batch(*args, **kwargs)
    
    The zigzag of every ship, in calm water, over packs and all cores.
    
    ships: of the model mmg, without effects. rudder, heading: angles [rad]. first: side turned to first. reversals: after whose overshoots a ship ends, 255 at most. speed: of the approach [m/s], of each ship her service speed unless given. rev: shaft speed [1/s], that of self-propulsion unless given. duration [s]: 200 L/U unless given. tolerance: error of an integration step. threads: 0 for one on each core. instruction_set: best, numbers, baseline, avx2 or avx512.
    
    Raises Refusal for another model or an effect; ValueError for angles that are not positive or beyond the largest of a ship, or an instruction set that is not there.
    
    The same for one ship with other values of her numbers.
    
    ship: of the model mmg, without effects. values: arrays by name, one value for each ship, in the units of the ship file: {"N_v": -0.14 * numpy.ones(1000), …}. Raises besides ValueError for a value that her file would refuse."""

def zigzag_order(run: Recording) -> Optional[ZigzagOrder]:
    """Rudder, heading and first side of the zigzag that a run says it is; None for other runs.
    
    run: its `manoeuvre` is read."""

def zigzag_slopes(ship: Ship, rudder: float, heading: float, parameters: List[str], first: str = ..., *, speed: Optional[float] = ...) -> dict:
    """Exact derivatives of the indices of a zigzag (SI) by parameters of the ship, in the units of her file: a dictionary from index to an array in the order of the names, None for an index that does not exist. Raises Refusal for a ship in wind or with effects other than a current.
    
    ship: of any nonlinear model. rudder, heading: angles [rad], positive. parameters: names. first: side turned to first. speed: of the approach [m/s], the service speed unless given."""
