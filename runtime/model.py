"""The model that users have: what was emitted, and all that can be asked of it."""

from __future__ import annotations

import copyreg
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.lazy_method import LazyMethod
from runtime.contract.loading import load_folder
from runtime.contract.model import EmittedModel, model_card
from runtime.contract.pickled_models import reduced

if TYPE_CHECKING:
    from runtime.baselines.ode import ode as _ode
    from runtime.export.c_bundle import export_c as _export_c
    from runtime.export.fmu import export_fmu as _export_fmu
    from runtime.export.jax_functions import to_jax as _to_jax
    from runtime.gradients.differentiable_run import gradient as _gradient
    from runtime.gradients.differentiable_run import output_jacobian as _output_jacobian
    from runtime.gradients.fit import fit as _fit
    from runtime.operating.campbell import campbell as _campbell
    from runtime.operating.dynamics import Dynamics
    from runtime.operating.equilibrium import equilibrium as _equilibrium
    from runtime.operating.linearise import linearise as _linearise
    from runtime.operating.modes import modes as _modes
    from runtime.operating.unbalance import unbalance_response as _unbalance_response
    from runtime.orbits.continuation import periodic_over as _periodic_over
    from runtime.orbits.periodic import periodic as _periodic
    from runtime.running.driven import quasi_static_motion as _quasi_static_motion
    from runtime.running.resume import resume as _resume
    from runtime.running.simulate import simulate as _simulate
    from runtime.running.stepping import stepper as _stepper
    from runtime.studies.advice.advise import advise as _advise
    from runtime.studies.advice.report import report as _report
    from runtime.studies.convergence import convergence as _convergence
    from runtime.studies.ensemble.ensemble import ensemble as _ensemble
    from runtime.studies.ensemble.lane_stepper import lanes as _lanes
    from runtime.studies.stability.chart import stability_chart as _stability_chart
    from runtime.studies.steady_states import fit_periodic as _fit_periodic
    from runtime.studies.steady_states import periodic_cases as _periodic_cases


class Model(EmittedModel):
    """A mechanism ready to run: its equations as CasADi functions, and the studies that can be made of them.

    Runs: simulate, resume, ensemble, stepper, lanes. States: equilibrium, modes, linearise, campbell,
    unbalance_response, quasi_static_motion. Motions that repeat: periodic, periodic_over, periodic_cases,
    fit_periodic. Derivatives: gradient, output_jacobian, fit. Methods: advise, report, stability. Modelling:
    convergence. Dynamics: mass_matrix, coriolis, gravity, inverse_dynamics, forward_dynamics, jacobian, ode. Names:
    q_i, q_d, coordinates, parameters, inputs, measures, joints, constraints. Functions: function, evaluate. Handed on:
    export_c, export_fmu, to_jax.
    """

    # Each of these is the function that it names, with the model as its first argument.
    if TYPE_CHECKING:
        simulate = _simulate
        resume = _resume
        ensemble = _ensemble
        equilibrium = _equilibrium
        modes = _modes
        linearise = _linearise
        campbell = _campbell
        unbalance_response = _unbalance_response
        periodic = _periodic
        periodic_over = _periodic_over
        periodic_cases = _periodic_cases
        fit_periodic = _fit_periodic
        quasi_static_motion = _quasi_static_motion
        gradient = _gradient
        output_jacobian = _output_jacobian
        fit = _fit
        advise = _advise
        report = _report
        stability = _stability_chart
        convergence = _convergence
        stepper = _stepper
        lanes = _lanes
        ode = _ode
        export_c = _export_c
        export_fmu = _export_fmu
        to_jax = _to_jax
    else:

        @LazyMethod
        def simulate():
            from runtime.running.simulate import simulate

            return simulate

        @LazyMethod
        def resume():
            from runtime.running.resume import resume

            return resume

        @LazyMethod
        def ensemble():
            from runtime.studies.ensemble.ensemble import ensemble

            return ensemble

        @LazyMethod
        def equilibrium():
            from runtime.operating.equilibrium import equilibrium

            return equilibrium

        @LazyMethod
        def modes():
            from runtime.operating.modes import modes

            return modes

        @LazyMethod
        def linearise():
            from runtime.operating.linearise import linearise

            return linearise

        @LazyMethod
        def campbell():
            from runtime.operating.campbell import campbell

            return campbell

        @LazyMethod
        def unbalance_response():
            from runtime.operating.unbalance import unbalance_response

            return unbalance_response

        @LazyMethod
        def periodic():
            from runtime.orbits.periodic import periodic

            return periodic

        @LazyMethod
        def periodic_over():
            from runtime.orbits.continuation import periodic_over

            return periodic_over

        @LazyMethod
        def periodic_cases():
            from runtime.studies.steady_states import periodic_cases

            return periodic_cases

        @LazyMethod
        def fit_periodic():
            from runtime.studies.steady_states import fit_periodic

            return fit_periodic

        @LazyMethod
        def quasi_static_motion():
            from runtime.running.driven import quasi_static_motion

            return quasi_static_motion

        @LazyMethod
        def gradient():
            from runtime.gradients.differentiable_run import gradient

            return gradient

        @LazyMethod
        def output_jacobian():
            from runtime.gradients.differentiable_run import output_jacobian

            return output_jacobian

        @LazyMethod
        def fit():
            from runtime.gradients.fit import fit

            return fit

        @LazyMethod
        def advise():
            from runtime.studies.advice.advise import advise

            return advise

        @LazyMethod
        def report():
            from runtime.studies.advice.report import report

            return report

        @LazyMethod
        def stability():
            from runtime.studies.stability.chart import stability_chart

            return stability_chart

        @LazyMethod
        def convergence():
            from runtime.studies.convergence import convergence

            return convergence

        @LazyMethod
        def stepper():
            from runtime.running.stepping import stepper

            return stepper

        @LazyMethod
        def lanes():
            from runtime.studies.ensemble.lane_stepper import lanes

            return lanes

        @LazyMethod
        def ode():
            from runtime.baselines.ode import ode

            return ode

        @LazyMethod
        def export_c():
            from runtime.export.c_bundle import export_c

            return export_c

        @LazyMethod
        def export_fmu():
            from runtime.export.fmu import export_fmu

            return export_fmu

        @LazyMethod
        def to_jax():
            from runtime.export.jax_functions import to_jax

            return to_jax

    def _dynamics(self) -> Dynamics:
        from runtime.operating.dynamics import Dynamics

        return Dynamics(self)

    @arguments()
    def inverse_dynamics(self, q: Any, v: Any, a: Any, motors: Sequence[str] = (), **where: Any) -> np.ndarray:
        """Find the generalised forces of a motion, tau = M_hat a - Q_hat.

        Parameters
        ----------
        q : (n_i,) array
            Independent coordinates q_i [m, rad].
        v : (n_i,) array
            Rates of q_i [m/s, rad/s].
        a : (n_i,) array
            Accelerations of q_i [m/s^2, rad/s^2].
        motors : sequence of str
            Inputs to solve for instead, of least norm.
        **where
            t [s]; parameters by name; near: a configuration that closes the loops.

        Returns
        -------
        (n_i,) or (k,) array
            Forces [N, N m] of the coordinates, or values of the motors.

        Raises
        ------
        ModelError, InitialStateError
            For numbers of another shape, unknown names, a q that does not close the loops, and motors that cannot make
            the motion.
        """
        return self._dynamics().inverse_dynamics(q, v, a, motors, **where)

    def forward_dynamics(self, q: Any, v: Any, tau: Any = None, **where: Any) -> np.ndarray:
        """Find the accelerations under the loads of the scene, M_hat q_i_ddot = Q_hat + tau (Eq. 38).

        Parameters
        ----------
        q : (n_i,) array
            Independent coordinates q_i [m, rad].
        v : (n_i,) array
            Rates of q_i [m/s, rad/s].
        tau : (n_i,) array, optional
            Further generalised forces [N, N m].
        **where
            t [s]; parameters by name; near: a configuration that closes the loops. As of `inverse_dynamics`.

        Returns
        -------
        (n_i,) array
            Accelerations of q_i [m/s^2, rad/s^2].

        Raises
        ------
        ModelError, InitialStateError
            For numbers of another shape, unknown names, and a q that does not close the loops.
        """
        return self._dynamics().forward_dynamics(q, v, tau, **where)

    def mass_matrix(self, q: Any, **where: Any) -> np.ndarray:
        """Find the mass matrix M_hat(q) of the independent coordinates (Eq. 38).

        Parameters
        ----------
        q : (n_i,) array
            Independent coordinates q_i [m, rad].
        **where
            t [s]; parameters by name; near: a configuration that closes the loops. As of `inverse_dynamics`.

        Returns
        -------
        (n_i, n_i) array
            In kg, kg m and kg m^2.

        Raises
        ------
        ModelError, InitialStateError
            For numbers of another shape, unknown names, and a q that does not close the loops.
        """
        return self._dynamics().mass_matrix(q, **where)

    def gravity(self, q: Any, **where: Any) -> np.ndarray:
        """Find the generalised forces that hold the mechanism still at q.

        Parameters
        ----------
        q : (n_i,) array
            Independent coordinates q_i [m, rad].
        **where
            t [s]; parameters by name; near: a configuration that closes the loops. As of `inverse_dynamics`.

        Returns
        -------
        (n_i,) array
            Forces [N, N m] against weight, springs and all other loads at rest.

        Raises
        ------
        ModelError, InitialStateError
            For numbers of another shape, unknown names, and a q that does not close the loops.
        """
        return self._dynamics().gravity(q, **where)

    def coriolis(self, q: Any, v: Any, **where: Any) -> np.ndarray:
        """Find what the generalised forces have more because of the velocities, C(q, v) v.

        Parameters
        ----------
        q : (n_i,) array
            Independent coordinates q_i [m, rad].
        v : (n_i,) array
            Rates of q_i [m/s, rad/s].
        **where
            t [s]; parameters by name; near: a configuration that closes the loops. As of `inverse_dynamics`.

        Returns
        -------
        (n_i,) array
            Centrifugal, gyroscopic and damping forces [N, N m].

        Raises
        ------
        ModelError, InitialStateError
            For numbers of another shape, unknown names, and a q that does not close the loops.
        """
        return self._dynamics().coriolis(q, v, **where)

    @arguments()
    def jacobian(self, marker: str, q: Any, **where: Any) -> np.ndarray:
        """Find how a marker moves with the rates of q_i, in axes of the world.

        Parameters
        ----------
        marker : str
            "body.marker".
        q : (n_i,) array
            Independent coordinates q_i [m, rad].
        **where
            t [s]; parameters by name; near: a configuration that closes the loops. As of `inverse_dynamics`.

        Returns
        -------
        (6, n_i) array, in the plane (3, n_i)
            Its velocity [m/s] and the angular velocity [rad/s] there are J v.

        Raises
        ------
        ModelError, InitialStateError
            For numbers of another shape, unknown names, and a q that does not close the loops.
        """
        return self._dynamics().jacobian(marker, q, **where)

    def _repr_html_(self) -> str:
        from runtime.views.film import model_sketch

        return model_card(self.description, model_sketch(self))


copyreg.pickle(Model, reduced)


@arguments()
def load_model(folder: str | Path, digest: str | None = None) -> Model:
    """Load a folder written by `symgen generate`, after comparing its files with the manifest's hashes.

    Loading runs the folder's model.py: load only what you or somebody you trust generated.

    Parameters
    ----------
    folder : path
        The folder.
    digest : str, optional
        The `model.digest` that is meant; a folder that holds another model is refused before any of its code runs.

    Returns
    -------
    Model
        The mechanism, ready to run.

    Raises
    ------
    ModelError
        If files are missing, were edited since generation, or belong to another format.
    """
    return load_folder(folder, Model, digest)
