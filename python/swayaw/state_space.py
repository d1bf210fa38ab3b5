"""Linear models as matrices, for scipy.signal and python-control."""

from __future__ import annotations

from dataclasses import dataclass

import numpy


@dataclass(frozen=True, eq=False)
class StateSpace:
    """d(x)/dt = A x + B u,  y = C x + D u; time in seconds, or in ship lengths for `unit` "L/U"."""

    A: numpy.ndarray
    B: numpy.ndarray
    C: numpy.ndarray
    D: numpy.ndarray
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    unit: str = "s"

    def to_scipy(self):
        """As scipy.signal.StateSpace."""
        from scipy.signal import StateSpace as Scipy

        return Scipy(self.A, self.B, self.C, self.D)

    def to_control(self):
        """As control.StateSpace of python-control, with the names of states, inputs and outputs."""
        import control

        return control.ss(
            self.A, self.B, self.C, self.D, states=list(self.states), inputs=list(self.inputs), outputs=list(self.outputs)
        )

    @property
    def poles(self) -> numpy.ndarray:
        """Eigenvalues of A."""
        return numpy.linalg.eigvals(self.A)

    def __repr__(self) -> str:
        return f"<StateSpace {', '.join(self.inputs)} -> {', '.join(self.outputs)}; states {', '.join(self.states)}, {self.unit}>"


def _all_states(A, B, states, heading, unit="s") -> StateSpace:
    """Every state is an output; the last one is the yaw rate, and the heading its integral."""
    if heading:
        size = A.shape[0]
        A = numpy.block([[A, numpy.zeros((size, 1))], [numpy.eye(1, size + 1, size - 1)]])
        B, states = numpy.vstack([B, [[0.0]]]), states + ("psi",)
    size = A.shape[0]
    return StateSpace(A, B, numpy.eye(size), numpy.zeros((size, 1)), states, ("delta",), states, unit)


def of_linearization(self, heading: bool = False) -> StateSpace:
    """The linear model with the states u, v, r as outputs, and psi where `heading` asks for it: d(psi)/dt = r."""
    return _all_states(self.A, self.B, tuple(self.states), heading)


def of_coefficients(self, heading: bool = False) -> StateSpace:
    """The coupled equations in dimensionless time: states beta, omega', and psi where `heading` asks for it."""
    A = numpy.array([[self.a1, self.b1], [self.a2, self.b2]])
    return _all_states(A, numpy.array([[self.c1], [self.c2]]), ("beta", "omega"), heading, "L/U")


def of_dimensional(self, heading: bool = False) -> StateSpace:
    """The coupled equations in seconds: states v [m/s], r [rad/s], and psi where `heading` asks for it."""
    A = numpy.array([[self.v_v, self.v_r], [self.r_v, self.r_r]])
    return _all_states(A, numpy.array([[self.v_delta], [self.r_delta]]), ("v", "r"), heading)


def dress(module) -> None:
    module.Linearization.state_space = of_linearization
    module.SwayYawCoefficients.state_space = of_coefficients
    module.DimensionalSwayYaw.state_space = of_dimensional
