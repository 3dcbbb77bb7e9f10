"""What the reference shows: public names by topic, from their docstrings by mkdocstrings, which imports nothing."""

TOPICS: dict[str, list[str]] = {
    "Scenes and code": [
        "symgen.mechanism.builder.Scene",
        "symgen.mechanism.entries.SceneEntries",
        "symgen.mechanism.scene.SceneRecord",
        "symgen.schema.errors.SceneError",
        "symgen.derivation.generate",
        "symgen.urdf.scene.read",
        "symgen.fe.body.FlexibleBody",
        "symgen.fe.matrix_files.read_matrix",
        "symgen.fe.matrix_files.read_dof_map",
        "symgen.fe.reduced.ReducedBody",
    ],
    "Models and runs": [
        "runtime.model.load_model",
        "runtime.model.Model",
        "runtime.contract.model.EmittedModel",
        "runtime.running.simulate.simulate",
        "runtime.running.resume.resume",
        "runtime.running.stepping.stepper",
        "runtime.running.stepping.ModelStepper",
        "runtime.studies.ensemble.ensemble.ensemble",
        "runtime.contract.status.Status",
    ],
    "Solutions": [
        "runtime.solutions.solution.Solution",
        "runtime.results.samples.Samples",
        "runtime.results.section_forces.section_forces",
        "runtime.results.deflections.deflections",
        "runtime.results.stresses.stresses",
        "runtime.results.friction.joint_friction",
        "runtime.results.friction.joint_stop",
        "runtime.results.body_motion.body_motion",
        "runtime.results.export.export",
        "runtime.results.export.columns",
        "runtime.results.export.write_npz",
    ],
    "Working points": [
        "runtime.operating.equilibrium.equilibrium",
        "runtime.operating.equilibrium.Equilibrium",
        "runtime.operating.linearise.linearise",
        "runtime.operating.linearisation.Linearisation",
        "runtime.operating.modes.modes",
        "runtime.operating.modes.ModeTable",
        "runtime.operating.campbell.campbell",
        "runtime.operating.unbalance.unbalance_response",
        "runtime.solutions.mode_motion.mode_motion",
        "runtime.running.driven.quasi_static_motion",
    ],
    "Motions that repeat": [
        "runtime.orbits.periodic.periodic",
        "runtime.orbits.motion.PeriodicMotion",
        "runtime.orbits.continuation.periodic_over",
        "runtime.studies.steady_states.periodic_cases",
        "runtime.studies.steady_states.fit_periodic",
        "runtime.orbits.branch.PeriodicBranch",
    ],
    "Derivatives and fits": [
        "runtime.gradients.differentiable_run.gradient",
        "runtime.gradients.differentiable_run.output_jacobian",
        "runtime.gradients.differentiable_run.DifferentiableRun",
        "runtime.gradients.fit.fit",
        "runtime.gradients.recorded_run.RecordedRun",
        "runtime.gradients.run_in_jax.as_jax",
        "runtime.gradients.run_in_torch.as_torch",
    ],
    "Judging": [
        "runtime.studies.convergence.convergence",
        "runtime.studies.convergence.Convergence",
        "runtime.studies.convergence.ModellingError",
        "runtime.studies.convergence.Change",
        "runtime.studies.advice.advise.advise",
        "runtime.studies.advice.report.report",
        "runtime.studies.stability.chart.stability_chart",
        "runtime.baselines.scipy_methods.reference_solution",
    ],
    "Schemes": [
        "runtime.schemes.central_difference.SingleRate",
        "runtime.schemes.printed.Printed",
        "runtime.schemes.coupled.Coupled",
        "runtime.schemes.exponential.Exponential",
        "runtime.schemes.exponential_rk4.ExponentialRungeKutta",
        "runtime.schemes.exponential_adams.ExponentialAdams",
        "runtime.schemes.runge_kutta.ClassicalRungeKutta",
        "runtime.schemes.runge_kutta.DormandPrince5",
        "runtime.schemes.runge_kutta.DormandPrince8",
        "runtime.schemes.radau.Radau",
    ],
    "Exporting": [
        "runtime.export.c_bundle.export_c",
        "runtime.export.fmu.export_fmu",
        "runtime.export.jax_functions.to_jax",
        "runtime.export.jax_functions.JaxFunction",
        "runtime.baselines.ode.ode",
    ],
    "Pictures": [
        "runtime.views.plots",
        "runtime.views.animation.snapshots",
        "runtime.views.animation.animate",
        "runtime.views.plots.campbell_picture",
    ],
}
HEAD = """# {topic}

From the docstrings, as `help(...)` shows them. Quantities are in SI units; n, n_i and N are the numbers of coordinates,
of independent coordinates and of samples.
"""


def pages() -> dict[str, str]:
    """Markdown of each topic's page by its name."""
    return {
        f"{topic.lower().replace(' ', '-')}.md": HEAD.format(topic=topic) + "".join(f"\n::: {name}\n" for name in names)
        for topic, names in TOPICS.items()
    }
