# ruff: noqa: E501
"""Methods of `Scene` that add a body, a joint, a coupling or a load, from the fields of their records.

Written by `python -m symgen.mechanism.entry_stubs`.
"""

from collections.abc import Mapping, Sequence
from typing import Any, Literal, Self, TypeAlias

import numpy as np

Quantity: TypeAlias = float | str | np.number[Any]
Array: TypeAlias = Sequence[Any] | np.ndarray[Any, Any]
Orientation: TypeAlias = Literal[
    "euler_parameters", "xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"
]

class SceneEntries:
    """Bodies, joints, couplings and loads that can be added to a `Scene`, a method for each type."""

    def rigid(
        self,
        name: str,
        mass: Quantity,
        inertia: Quantity | Array,
        *,
        products: Array = ...,
        center_of_mass: Array = ...,
        orientation: Orientation = ...,
        free: bool = ...,
        as_given: bool = ...,
        markers: Mapping[str, Any] = ...,
        shape: Mapping[str, Any] | Array = ...,
    ) -> Self:
        """Add a body of the type `rigid`.

        A rigid body with coordinates R_o, theta of its frame.

        mass [kg]; inertia [kg m^2] about the centre of mass: one number in a planar scene, the entries xx, yy, zz of the
        inertia tensor in a spatial one, where products are its entries xy, xz, yz; center_of_mass [m] in the body frame.
        orientation (spatial): a sequence of axes if the body's Euler angles are wanted as input and output.
        ``free = true`` says that no joint is intended. shape: how pictures show it, in place of rods between its markers.
        ``as_given = true`` takes moments of inertia that no mass distribution has.

        Parameters
        ----------
        name : str
            Name of the body, by which expressions, results and messages refer to it.
        mass : float or expression
            Mass [kg]; not negative.
        inertia : float or expression or sequence
            Moment of inertia about the centre of mass [kg m^2]; not negative.
        products : sequence, default (0.0, 0.0, 0.0)
            Entries xy, xz, yz of the inertia tensor [kg m^2].
        center_of_mass : sequence, default (0.0, 0.0)
            Position in the body frame, (x, y) or (x, y, z) [m].
        orientation : {"euler_parameters", "xyz", "xzy", "yxz", "yzx", "zxy", ...}, default "euler_parameters"
            Spatial: a sequence of axes if the body's Euler angles are wanted as input and output.
        free : bool, default False
            Whether it stands without a joint on purpose, so that none is asked for.
        as_given : bool, default False
            Whether moments of inertia that no mass distribution has are taken.
        markers : mapping of str to mapping, optional
            Points by name, which joints, loads and measures refer to as `"body.marker"`; each has a position [m]
            and an angle [rad], or axes in space. Keys: angle [rad], axis, x_axis, position [m].
        shape : sequence, optional
            How pictures show it, instead of rods between its markers: boxes, cylinders, spheres, meshes. Keys:
            position, axis, x_axis, type, size. Keys: position, axis, x_axis, type, radius, length. Keys: position,
            axis, x_axis, type, radius. Keys: position, axis, x_axis, type, vertices, triangles.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its mass matrix, quadratic velocity forces and stiffness are those of Eqs. 15-20.
        """

    def beam(
        self,
        name: str,
        length: Quantity,
        density: Quantity,
        area: Quantity,
        second_moment: Quantity,
        youngs_modulus: Quantity,
        *,
        lateral: Mapping[str, Any] | None = ...,
        second_moment_z: Quantity = ...,
        lateral_z: Mapping[str, Any] | None = ...,
        axial: Mapping[str, Any] | None = ...,
        shear_modulus: Quantity = ...,
        torsion_constant: Quantity = ...,
        section_modulus: Quantity | None = ...,
        section_modulus_z: Quantity | None = ...,
        torsion_modulus: Quantity | None = ...,
        shear_factor: Quantity = ...,
        torsion: Mapping[str, Any] | None = ...,
        stiffening: bool = ...,
        damping_ratio: Quantity = ...,
        damping_frequency: Quantity | None = ...,
        mesh: Literal["exact", "lumped"] = ...,
        elements: int | None = ...,
        orientation: Orientation = ...,
        free: bool = ...,
        markers: Mapping[str, Any] = ...,
    ) -> Self:
        """Add a body of the type `beam`.

        A uniform beam (Eq. 15-20).

        length [m], density [kg/m^3], area [m^2], second_moment [m^4], youngs_modulus [Pa]; damping_ratio [1] of
        all modes; with damping_frequency [rad/s] it holds there, and damping is proportional to stiffness (Rayleigh), so
        that welded pieces have the ratio of the whole. The frame lies at the start with x along the undeformed beam. q_f
        holds the lateral modes, then the axial ones. In a spatial scene second_moment and lateral are those of bending in
        the xy-plane; second_moment_z and lateral_z those of bending in the xz-plane, whose modes come between the two.
        Torsion modes, the last ones, turn the sections about x [rad], with the stiffness shear_modulus [Pa] times
        torsion_constant [m^4], without warping. Measures of stress need section_modulus [m^3] (I over the distance of the
        outermost fibre), section_modulus_z, torsion_modulus [m^3] (torque over the largest shear stress) and shear_factor,
        the largest shear stress of a shear force over its mean: 1.5 of rectangles, 4/3 of circles.
        ``stiffening`` keeps the foreshortening (geometric stiffening) terms. mesh: "exact" shapes in closed form, or in a
        plane "lumped", the paper's mesh of so many `elements` with masses at its nodes (Eqs. 15-20), a modal body then.

        Parameters
        ----------
        name : str
            Name of the body, by which expressions, results and messages refer to it.
        length : float or expression
            Length [m]; positive.
        density : float or expression
            Density [kg/m^3]; positive.
        area : float or expression
            Area of the cross-section [m^2]; positive.
        second_moment : float or expression
            Second moment of area [m^4]; positive.
        youngs_modulus : float or expression
            Young's modulus [Pa]; positive.
        lateral : mapping, optional
            Bending modes, in a spatial scene of the xy-plane. Keys: ends, modes.
        second_moment_z : float or expression, default 0.0
            Second moment of area for the xz-plane [m^4]; not negative.
        lateral_z : mapping, optional
            Bending modes of the xz-plane (spatial). Keys: ends, modes.
        axial : mapping, optional
            Stretching modes. Keys: ends, modes.
        shear_modulus : float or expression, default 0.0
            Shear modulus [Pa]; not negative.
        torsion_constant : float or expression, default 0.0
            Torsion constant of the section [m^4]; not negative.
        section_modulus : float or expression, optional
            Section modulus [m^3]; positive.
        section_modulus_z : float or expression, optional
            Section modulus for the xz-plane [m^3]; positive.
        torsion_modulus : float or expression, optional
            Section modulus of torsion [m^3]; positive.
        shear_factor : float or expression, default 1.5
            Largest shear stress over its mean in the section [1]; not negative.
        torsion : mapping, optional
            Torsion modes (spatial). Keys: ends, modes.
        stiffening : bool, default False
            Whether to keep the foreshortening terms (geometric stiffening).
        damping_ratio : float or expression, default 0.0
            Damping ratio of all modes [1]; not negative.
        damping_frequency : float or expression, optional
            Frequency at which the damping ratio holds [rad/s]; positive.
        mesh : {"exact", "lumped"}, default "exact"
            Shapes in closed form, or the paper's lumped mesh (planar, Eqs. 15-20).
        elements : int, optional
            Number of elements of a lumped mesh.
        orientation : {"euler_parameters", "xyz", "xzy", "yxz", "yzx", "zxy", ...}, default "euler_parameters"
            Spatial: a sequence of axes if the body's Euler angles are wanted as input and output.
        free : bool, default False
            Whether it stands without a joint on purpose, so that none is asked for.
        markers : mapping of str to mapping, optional
            Points by name, which joints, loads and measures refer to as `"body.marker"`; `at` is a fraction of the
            length; `start` and `end` are there. Keys: angle [rad], axis, x_axis, at.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its mass matrix, quadratic velocity forces and stiffness are those of Eqs. 15-20.

        References
        ----------
        A. A. Shabana, Dynamics of Multibody Systems, 5th ed., Cambridge University Press, 2020, chapter 5.

        T. R. Kane, R. R. Ryan, A. K. Banerjee, Dynamics of a cantilever beam attached to a moving base, J. Guid.
        Control Dyn. 10 (1987) 139-151.
        """

    def modal(
        self,
        name: str,
        mass: Quantity,
        inertia: Quantity,
        M_ff: Array,
        K_ff: Array,
        *,
        first_moment: Array = ...,
        D_ff: Array | None = ...,
        phi_integral: Array = ...,
        rho_dot_phi: Array = ...,
        rho_cross_phi: Array = ...,
        phi_cross_phi: Array = ...,
        foreshortening: Mapping[str, Any] | None = ...,
        free: bool = ...,
        markers: Mapping[str, Any] = ...,
    ) -> Self:
        """Add a body of the type `modal`.

        A flexible body with given modal mass, stiffness, damping and inertia shape integrals (Eq. 20).

        mass [kg]; first_moment: int rho0 dm [kg m]; inertia: int |rho0|^2 dm [kg m^2], about the frame origin;
        M_ff, K_ff, D_ff: nf x nf; phi_integral: 2 x nf, int Phi dm; rho_dot_phi: nf, int rho0.Phi dm;
        rho_cross_phi: nf, int (x Phi_y - y Phi_x) dm; phi_cross_phi: nf x nf, skew,
        int (Phi_x,a Phi_y,b - Phi_y,a Phi_x,b) dm. Integrals left out are zero.

        Parameters
        ----------
        name : str
            Name of the body, by which expressions, results and messages refer to it.
        mass : float or expression
            Mass [kg]; positive.
        inertia : float or expression
            int |rho0|^2 dm about the frame origin [kg m^2]; not negative.
        M_ff : sequence, shape (nf, nf)
            Modal mass matrix [kg m^2 per unit of q_f^2].
        K_ff : sequence, shape (nf, nf)
            Modal stiffness matrix [N m per unit of q_f^2].
        first_moment : sequence, default (0.0, 0.0)
            int rho0 dm [kg m].
        D_ff : sequence, shape (nf, nf), optional
            Modal damping matrix [N m s per unit of q_f^2].
        phi_integral : sequence, shape (2, nf), optional
            int Phi dm, 2 x nf [kg m per unit of q_f].
        rho_dot_phi : sequence, shape (nf,), optional
            int rho0.Phi dm [kg m^2 per unit of q_f].
        rho_cross_phi : sequence, shape (nf,), optional
            int (x Phi_y - y Phi_x) dm [kg m^2 per unit of q_f].
        phi_cross_phi : sequence, shape (nf, nf), optional
            int (Phi_x Phi_y - Phi_y Phi_x) dm, skew [kg m^2].
        foreshortening : mapping, optional
            Integrals of second order for geometric stiffening. Keys: H [kg m per unit of q_f^2], xH [kg m^2 per
            unit of q_f^2].
        free : bool, default False
            Whether it stands without a joint on purpose, so that none is asked for.
        markers : mapping of str to mapping, optional
            Points by name, which joints, loads and measures refer to as `"body.marker"`; each has a position [m]
            and its shape functions. Keys: position [m], angle [rad], shape_x [m per unit of q_f], shape_y [m per
            unit of q_f], slope [rad per unit of q_f], foreshortening [m per unit of q_f^2].

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its mass matrix, quadratic velocity forces and stiffness are those of Eqs. 15-20.

        References
        ----------
        A. A. Shabana, Dynamics of Multibody Systems, 5th ed., Cambridge University Press, 2020, chapter 5.
        """

    def flexible(
        self,
        name: str,
        mass: Quantity,
        inertia_moments: Array,
        M_ff: Array,
        K_ff: Array,
        *,
        first_moment: Array = ...,
        D_ff: Array | None = ...,
        phi_integral: Array = ...,
        rho_phi: Array = ...,
        phi_phi: Array = ...,
        stiffening: Mapping[str, Any] | None = ...,
        orientation: Orientation = ...,
        free: bool = ...,
        surface: Mapping[str, Any] | None = ...,
        gauges: Mapping[str, Any] = ...,
        struts: Mapping[str, Any] | Array = ...,
        markers: Mapping[str, Any] = ...,
    ) -> Self:
        """Add a body of the type `flexible`.

        A flexible body in space: modal mass, stiffness, damping and shape integrals over the undeformed position rho0.

        mass [kg]; first_moment: int rho0 dm [kg m]; inertia_moments: int rho0_i rho0_j dm [kg m^2], 3 x 3 about the frame
        origin; M_ff, K_ff, D_ff: nf x nf; phi_integral: int Phi dm, 3 x nf; rho_phi[a, i, j] = int rho0_i Phi_ja dm;
        phi_phi[a, b, i, j] = int Phi_ia Phi_jb dm (left out: no terms of second order in q_f in the inertia); surface: for
        pictures; gauges: where stresses are known; struts: between which markers it buckles.

        Parameters
        ----------
        name : str
            Name of the body, by which expressions, results and messages refer to it.
        mass : float or expression
            Mass [kg]; positive.
        inertia_moments : sequence, shape (3, 3)
            int rho0_i rho0_j dm [kg m^2].
        M_ff : sequence, shape (nf, nf)
            Modal mass matrix [kg m^2 per unit of q_f^2].
        K_ff : sequence, shape (nf, nf)
            Modal stiffness matrix [N m per unit of q_f^2].
        first_moment : sequence, default (0.0, 0.0, 0.0)
            int rho0 dm [kg m].
        D_ff : sequence, shape (nf, nf), optional
            Modal damping matrix [N m s per unit of q_f^2].
        phi_integral : sequence, shape (3, nf), optional
            int Phi dm, 3 x nf [kg m per unit of q_f].
        rho_phi : sequence, shape (nf,), optional
            int rho0_i Phi_ja dm as [a, i, j], nf x 3 x 3 [kg m^2 per unit of q_f].
        phi_phi : sequence, shape (nf, nf), optional
            int Phi_ia Phi_jb dm as [a, b, i, j], nf x nf x 3 x 3 [kg m^2 per unit of q_f^2]; left out: no terms of
            second order in q_f in the inertia.
        stiffening : mapping, optional
            Integrals of second order for geometric stiffening. Keys: H, xH.
        orientation : {"euler_parameters", "xyz", "xzy", "yxz", "yzx", "zxy", ...}, default "euler_parameters"
            Spatial: a sequence of axes if the body's Euler angles are wanted as input and output.
        free : bool, default False
            Whether it stands without a joint on purpose, so that none is asked for.
        surface : mapping, optional
            Triangles for pictures, as `FlexibleBody.surface` gives them. Keys: vertices, triangles, shapes,
            stresses.
        gauges : mapping of str to mapping, optional
            Places where stresses are known, as `FlexibleBody.fields` gives them. Keys: position, shapes, fields,
            forces, error_shapes, error_fields, error_forces.
        struts : sequence, optional
            Loads at which it buckles, as `FlexibleBody.fields` gives them. Keys: markers, held, first, second.
        markers : mapping of str to mapping, optional
            Points by name, which joints, loads and measures refer to as `"body.marker"`; each has a position [m]
            and its shape functions. Keys: angle [rad], axis, x_axis, position [m], shape [m per unit of q_f],
            rotation [rad per unit of q_f], foreshortening.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its mass matrix, quadratic velocity forces and stiffness are those of Eqs. 15-20.

        References
        ----------
        A. A. Shabana, Dynamics of Multibody Systems, 5th ed., Cambridge University Press, 2020, chapter 5.
        """

    def cylindrical(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        *,
        damping: Quantity = ...,
        travel_damping: Quantity = ...,
    ) -> Self:
        """Add a joint of the type `cylindrical`.

        Turns about and slides along marker a's z-axis (spatial). damping [N m s/rad], travel_damping [N s/m].

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.
        damping : float or expression, default 0.0
            Damping of the rotation [N m s/rad]; not negative.
        travel_damping : float or expression, default 0.0
            Damping of the sliding [N s/m]; not negative.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        """

    def distance(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        length: Quantity,
    ) -> Self:
        """Add a joint of the type `distance`.

        A massless rod between two points: row |r_b - r_a|^2 - length^2. length [m].

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.
        length : float or expression
            Length of the rod [m]; positive.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        In the plane: ``|r_b - r_a| - length = 0``.
        """

    def planar(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
    ) -> Self:
        """Add a joint of the type `planar`.

        Moves in marker a's xy-plane and turns about its z-axis (spatial).

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        """

    def point_on_line(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
    ) -> Self:
        """Add a joint of the type `point_on_line`.

        Keeps marker_b's point on marker_a's x-axis, in space its z-axis: row n_a.(r_b - r_a), in space two.

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        In the plane: ``n_a . (r_b - r_a) = 0``.
        """

    def prescribed_angle(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        motion: Quantity,
    ) -> Self:
        """Add a joint of the type `prescribed_angle`.

        Prescribes an angle, in space about marker a's z-axis: row phi_b - phi_a - f(t), f = motion [rad].

        Between the markers of a joint with an angle of its own it prescribes that angle, over any number of turns.

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.
        motion : float or expression
            Angle as a function of t [rad]; expressions may use parameters, inputs and t.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        In the plane: ``phi_b - phi_a - f(t) = 0``.
        """

    def prescribed_displacement(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        motion: Quantity,
    ) -> Self:
        """Add a joint of the type `prescribed_displacement`.

        Prescribes a way along marker_a's x-axis, in space its z-axis: row t_a.(r_b - r_a) - f(t), f = motion [m].

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.
        motion : float or expression
            Displacement as a function of t [m]; expressions may use parameters, inputs and t.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        In the plane: ``t_a . (r_b - r_a) - f(t) = 0``.
        """

    def prismatic(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        *,
        damping: Quantity = ...,
        motor: Mapping[str, Any] | None = ...,
        limits: Mapping[str, Any] | None = ...,
        backlash: Mapping[str, Any] | None = ...,
        friction: Mapping[str, Any] | None = ...,
    ) -> Self:
        """Add a joint of the type `prismatic`.

        A slide along marker_a's x-axis, in space its z-axis: rows n_a.(r_b - r_a), phi_b - phi_a. damping [N s/m].

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.
        damping : float or expression, default 0.0
            Damping of the sliding [N s/m]; not negative.
        motor : mapping, optional
            Rotor that the joint carries on the body of marker a, about its axis. Keys: inertia [kg m^2], ratio [1
            or rad/m].
        limits : mapping, optional
            Stops at the ends of the free motion, rigid or compliant. Keys: lower [m or rad], upper [m or rad],
            restitution [1], beyond, stiffness [N/m^n or N m/rad^n], damping [s/m or s/rad], exponent.
        backlash : mapping, optional
            Play of the free motion: no force within the gap, a spring and damper beyond. Keys: gap [m or rad],
            stiffness [N/m or N m/rad], damping [N s/m or N m s/rad].
        friction : mapping, optional
            Friction of the free motion (Coulomb, Stribeck, viscous), which sticks at rest. Keys: coulomb [N or N
            m], breakaway [N or N m], stribeck_velocity [m/s or rad/s], stribeck [N or N m], viscous [N s/m or N m
            s/rad], mu [1], mu_static [1], radius [m].

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        In the plane: ``n_a . (r_b - r_a) = 0, phi_b - phi_a = 0``.

        References
        ----------
        K. H. Hunt, F. R. E. Crossley, Coefficient of restitution interpreted as damping in vibroimpact, J. Appl.
        Mech. 42 (1975) 440-445.

        B. Armstrong-Helouvry, P. Dupont, C. Canudas de Wit, A survey of models, analysis tools and compensation
        methods for the control of machines with friction, Automatica 30 (1994) 1083-1138.
        """

    def revolute(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        *,
        damping: Quantity = ...,
        motor: Mapping[str, Any] | None = ...,
        limits: Mapping[str, Any] | None = ...,
        backlash: Mapping[str, Any] | None = ...,
        friction: Mapping[str, Any] | None = ...,
    ) -> Self:
        """Add a joint of the type `revolute`.

        A hinge about marker a's z-axis: rows (r_b - r_a)_x, (r_b - r_a)_y; in space r_b - r_a and z_b parallel to z_a.

        damping [N m s/rad] resists the relative rotation.

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.
        damping : float or expression, default 0.0
            Damping of the rotation [N m s/rad]; not negative.
        motor : mapping, optional
            Rotor that the joint carries on the body of marker a, about its axis. Keys: inertia [kg m^2], ratio [1
            or rad/m].
        limits : mapping, optional
            Stops at the ends of the free motion, rigid or compliant. Keys: lower [m or rad], upper [m or rad],
            restitution [1], beyond, stiffness [N/m^n or N m/rad^n], damping [s/m or s/rad], exponent.
        backlash : mapping, optional
            Play of the free motion: no force within the gap, a spring and damper beyond. Keys: gap [m or rad],
            stiffness [N/m or N m/rad], damping [N s/m or N m s/rad].
        friction : mapping, optional
            Friction of the free motion (Coulomb, Stribeck, viscous), which sticks at rest. Keys: coulomb [N or N
            m], breakaway [N or N m], stribeck_velocity [m/s or rad/s], stribeck [N or N m], viscous [N s/m or N m
            s/rad], mu [1], mu_static [1], radius [m].

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        In the plane: ``r_b - r_a = 0``.

        References
        ----------
        K. H. Hunt, F. R. E. Crossley, Coefficient of restitution interpreted as damping in vibroimpact, J. Appl.
        Mech. 42 (1975) 440-445.

        B. Armstrong-Helouvry, P. Dupont, C. Canudas de Wit, A survey of models, analysis tools and compensation
        methods for the control of machines with friction, Automatica 30 (1994) 1083-1138.
        """

    def screw(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        lead: Quantity,
    ) -> Self:
        """Add a joint of the type `screw`.

        A cylindrical joint whose travel is lead times the turns (spatial): travel = lead angle / 2 pi. lead [m].

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.
        lead : float or expression
            Travel of a turn [m].

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        """

    def slides_on(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
    ) -> Self:
        """Add a joint of the type `slides_on`.

        Point b slides along the centre line of the beam of marker_a, which bends under it; it may turn.

        Rows y - phi(x) q_f = 0, in space also z - phi(x) q_f = 0, for the place (x, y, z) of point b in the beam's frame.

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        In the plane: ``y_b - phi(x_b) q_f = 0``.
        """

    def spherical(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
    ) -> Self:
        """Add a joint of the type `spherical`.

        A ball joint, free to turn about all axes: rows r_b - r_a (spatial).

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        """

    def universal(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
    ) -> Self:
        """Add a joint of the type `universal`.

        Turns about marker a's z-axis, then about b's x-axis: rows r_b - r_a and x_b perpendicular to z_a (spatial).

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        """

    def weld(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
    ) -> Self:
        """Add a joint of the type `weld`.

        Fixes b to a: rows (r_b - r_a)_x, (r_b - r_a)_y, phi_b - phi_a; in space r_b - r_a and axes along axes.

        Parameters
        ----------
        name : str
            Name of the joint, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21); the multipliers lam of these give its reaction (Eq. 22).
        In the plane: ``r_b - r_a = 0, phi_b - phi_a = 0``.
        """

    def belt(
        self,
        name: str,
        coordinate_a: str,
        coordinate_b: str,
        radius_a: Quantity,
        radius_b: Quantity,
        *,
        backlash: Mapping[str, Any] | None = ...,
        crossed: bool = ...,
    ) -> Self:
        """Add a coupling of the type `belt`.

        A belt or chain that does not slip: radius a times angle a = radius b times angle b [m].

        Parameters
        ----------
        name : str
            Name of the coupling, by which expressions, results and messages refer to it.
        coordinate_a : str
            Angle of pulley a, `"joint.angle"`.
        coordinate_b : str
            Angle of pulley b, `"joint.angle"`.
        radius_a : float or expression
            Radius of pulley a [m]; positive.
        radius_b : float or expression
            Radius of pulley b [m]; positive.
        backlash : mapping, optional
            Play between the two sides: no force within the gap, a spring and damper beyond. Keys: gap [m or rad],
            stiffness [N/m or N m/rad], damping [N s/m or N m s/rad].
        crossed : bool, default False
            Whether the belt crosses, so that the pulleys turn oppositely.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its row is part of C(q, t) = 0 (Eq. 21), with a constant Jacobian C_q.
        """

    def differential(
        self,
        name: str,
        input: str,
        output_a: str,
        output_b: str,
        *,
        backlash: Mapping[str, Any] | None = ...,
        ratio: Quantity = ...,
    ) -> Self:
        """Add a coupling of the type `differential`.

        A differential: input angle = ratio (angle a + angle b) / 2, with equal torques on a and b.

        Parameters
        ----------
        name : str
            Name of the coupling, by which expressions, results and messages refer to it.
        input : str
            Angle of the input, `"joint.angle"`.
        output_a : str
            Angle of output a, `"joint.angle"`.
        output_b : str
            Angle of output b, `"joint.angle"`.
        backlash : mapping, optional
            Play between the two sides: no force within the gap, a spring and damper beyond. Keys: gap [m or rad],
            stiffness [N/m or N m/rad], damping [N s/m or N m s/rad].
        ratio : float or expression, default 1.0
            Turns of the input for a turn of both outputs [1].

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its row is part of C(q, t) = 0 (Eq. 21), with a constant Jacobian C_q.
        """

    def gear(
        self,
        name: str,
        coordinate_a: str,
        coordinate_b: str,
        ratio: Quantity,
        *,
        backlash: Mapping[str, Any] | None = ...,
    ) -> Self:
        """Add a coupling of the type `gear`.

        A gear: angle a = ratio times angle b. ratio: turns of a for a turn of b, negative where they turn oppositely.

        Two wheels in mesh on the outside: ratio = -(teeth of b) / (teeth of a).

        Parameters
        ----------
        name : str
            Name of the coupling, by which expressions, results and messages refer to it.
        coordinate_a : str
            Angle of wheel a, `"joint.angle"`.
        coordinate_b : str
            Angle of wheel b, `"joint.angle"`.
        ratio : float or expression
            Turns of a for a turn of b [1].
        backlash : mapping, optional
            Play between the two sides: no force within the gap, a spring and damper beyond. Keys: gap [m or rad],
            stiffness [N/m or N m/rad], damping [N s/m or N m s/rad].

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its row is part of C(q, t) = 0 (Eq. 21), with a constant Jacobian C_q.
        """

    def mimic(
        self,
        name: str,
        coordinate: str,
        follows: str,
        *,
        backlash: Mapping[str, Any] | None = ...,
        multiplier: Quantity = ...,
        offset: Quantity = ...,
    ) -> Self:
        """Add a coupling of the type `mimic`.

        Ties a coordinate to another one: coordinate = multiplier times that + offset [rad or m].

        Parameters
        ----------
        name : str
            Name of the coupling, by which expressions, results and messages refer to it.
        coordinate : str
            Coordinate that is tied, `"joint.angle"` or `"joint.travel"`.
        follows : str
            Coordinate of the same kind that it follows.
        backlash : mapping, optional
            Play between the two sides: no force within the gap, a spring and damper beyond. Keys: gap [m or rad],
            stiffness [N/m or N m/rad], damping [N s/m or N m s/rad].
        multiplier : float or expression, default 1.0
            What the coordinate does for a unit of the one that it follows [1].
        offset : float or expression, default 0.0
            Value where the one that it follows is zero [rad or m].

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its row is part of C(q, t) = 0 (Eq. 21), with a constant Jacobian C_q.
        """

    def rack(
        self,
        name: str,
        rack: str,
        pinion: str,
        radius: Quantity,
        *,
        backlash: Mapping[str, Any] | None = ...,
    ) -> Self:
        """Add a coupling of the type `rack`.

        A rack and pinion: travel = radius times angle; radius [m] negative where the rack runs against the pinion.

        Parameters
        ----------
        name : str
            Name of the coupling, by which expressions, results and messages refer to it.
        rack : str
            Travel of the rack, `"joint.travel"`.
        pinion : str
            Angle of the pinion, `"joint.angle"`.
        radius : float or expression
            Pitch radius of the pinion [m].
        backlash : mapping, optional
            Play between the two sides: no force within the gap, a spring and damper beyond. Keys: gap [m or rad],
            stiffness [N/m or N m/rad], damping [N s/m or N m s/rad].

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its row is part of C(q, t) = 0 (Eq. 21), with a constant Jacobian C_q.
        """

    def bushing(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        *,
        stiffness: Array = ...,
        damping: Array = ...,
        rotational_stiffness: Array = ...,
        rotational_damping: Array = ...,
    ) -> Self:
        """Add a load of the type `bushing`.

        Springs and dampers along and about marker a's axes on the displacement and small rotation of b (spatial).

        stiffness [N/m], damping [N s/m], rotational_stiffness [N m/rad], rotational_damping [N m s/rad]: three each.

        Parameters
        ----------
        name : str
            Name of the load, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`; its axes are those of the bushing.
        marker_b : str
            Marker b, `"body.marker"`.
        stiffness : sequence, default (0.0, 0.0, 0.0)
            Stiffness along x, y, z [N/m]; not negative.
        damping : sequence, default (0.0, 0.0, 0.0)
            Damping along x, y, z [N s/m]; not negative.
        rotational_stiffness : sequence, default (0.0, 0.0, 0.0)
            Stiffness about x, y, z [N m/rad]; not negative.
        rotational_damping : sequence, default (0.0, 0.0, 0.0)
            Damping about x, y, z [N m s/rad]; not negative.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its generalised force is part of Q in the equations of motion (Eq. 22).
        """

    def contact(
        self,
        name: str,
        marker: str,
        radius: Quantity,
        stiffness: Quantity,
        *,
        plane: str | None = ...,
        other: str | None = ...,
        other_radius: Quantity = ...,
        damping: Quantity = ...,
        exponent: float = ...,
        friction: Quantity = ...,
        slip_speed: Quantity = ...,
    ) -> Self:
        """Add a load of the type `contact`.

        A ball (in the plane a disc) about `marker`, pressed by d against the plane of the marker `plane`, through it and
        across its z-axis (in the plane: its y-axis), on the side of that axis; or against the ball about `other`.

        Normal force k d^n max(0, 1 + D d'), which never pulls; stiffness k [N/m^n], damping D [s/m], exponent n. Friction
        -friction N v_t / sqrt(v_t^2 + slip_speed^2) of the points that touch: it is smooth and creeps, and holds nothing.

        Parameters
        ----------
        name : str
            Name of the load, by which expressions, results and messages refer to it.
        marker : str
            Centre of the ball, `"body.marker"`.
        radius : float or expression
            Radius of the ball [m]; not negative.
        stiffness : float or expression
            Stiffness of the contact [N/m^n]; positive.
        plane : str, optional
            Marker of the plane that the ball meets; this or `other`.
        other : str, optional
            Centre of another ball that it meets; this or `plane`.
        other_radius : float or expression, default 0.0
            Radius of the other ball [m]; not negative.
        damping : float or expression, default 0.0
            Damping of the contact [s/m]; not negative.
        exponent : float, default 1.0
            Exponent n of the force [1], from 1 (linear) to 5; 1.5 of Hertz.
        friction : float or expression, default 0.0
            Coefficient of friction [1]; not negative.
        slip_speed : float or expression, default 0.001
            Speed at which friction is 0.7 of its value [m/s]; positive.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its generalised force is part of Q in the equations of motion (Eq. 22).

        References
        ----------
        K. H. Hunt, F. R. E. Crossley, Coefficient of restitution interpreted as damping in vibroimpact, J. Appl.
        Mech. 42 (1975) 440-445.
        """

    def distributed(
        self,
        name: str,
        beam: str,
        components: Array,
        *,
        frame: Literal["world", "body", "section"] = ...,
        start: float = ...,
        end: float = ...,
    ) -> Self:
        """Add a load of the type `distributed`.

        A force per length [N/m] on a beam, from the fraction `start` of its length to `end`.

        components: expressions of the place `s` [m] from the beam's start and of all that loads may use. frame: "world";
        "body", turning with the beam's frame; "section", turning with each section, as a pressure does.

        Parameters
        ----------
        name : str
            Name of the load, by which expressions, results and messages refer to it.
        beam : str
            Name of the beam.
        components : sequence
            Force per length [N/m]; expressions may use parameters, inputs, t, measures, states and their rates, and
            the place s along the beam.
        frame : {"world", "body", "section"}, default "world"
            Axes of the components: the world's, the beam's frame, or those of each section, as a pressure has.
        start : float, default 0.0
            Where it begins, as a fraction of the length [1].
        end : float, default 1.0
            Where it ends, as a fraction of the length [1].

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its generalised force is part of Q in the equations of motion (Eq. 22).
        """

    def effort(
        self,
        name: str,
        coordinate: str,
        value: Quantity,
    ) -> Self:
        """Add a load of the type `effort`.

        A motor on a joint's own coordinate: a torque [N m] on an angle, a force [N] on a travel.

        coordinate: "joint.angle" or "joint.travel", and in space "joint.angle1", "joint.angle2", "joint.x", "joint.y" where
        the joint has these. It acts on marker b along the coordinate, and its opposite on marker a.

        Parameters
        ----------
        name : str
            Name of the load, by which expressions, results and messages refer to it.
        coordinate : str
            Coordinate of a joint that it drives, `"joint.angle"` or `"joint.travel"`.
        value : float or expression
            Torque or force [N m or N]; expressions may use parameters, inputs, t, measures, states and their rates.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its generalised force is part of Q in the equations of motion (Eq. 22).
        """

    def line(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        value: Quantity,
    ) -> Self:
        """Add a load of the type `line`.

        A force [N] that pulls two markers together where it is positive: cables, hydraulics, dampers by a table.

        value: an expression of `length` [m] and `rate` [m/s] of the line, and of all that loads may use.

        Parameters
        ----------
        name : str
            Name of the load, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.
        value : float or expression
            Force that pulls the markers together [N]; expressions may use parameters, inputs, t, measures, states
            and their rates, and length and rate of the line.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its generalised force is part of Q in the equations of motion (Eq. 22).
        """

    def moving_force(
        self,
        name: str,
        beam: str,
        place: Quantity,
        components: Array,
        *,
        frame: Literal["world", "section"] = ...,
    ) -> Self:
        """Add a load of the type `moving_force`.

        A force [N] at `place` [m] from a beam's start, an expression of t, measures, states; none beyond its ends.

        frame: "world", or "section": turning with the section where it is.

        Parameters
        ----------
        name : str
            Name of the load, by which expressions, results and messages refer to it.
        beam : str
            Name of the beam.
        place : float or expression
            Place on the beam, from its start [m]; expressions may use parameters, inputs, t, measures, states and
            their rates.
        components : sequence
            Force, (x, y) or (x, y, z) [N]; expressions may use parameters, inputs, t, measures, states and their
            rates.
        frame : {"world", "section"}, default "world"
            Axes of the components: the world's, or those of the section where it is.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its generalised force is part of Q in the equations of motion (Eq. 22).
        """

    def rotational_spring_damper(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        stiffness: Quantity,
        *,
        damping: Quantity = ...,
        free_angle: Quantity = ...,
    ) -> Self:
        """Add a load of the type `rotational_spring_damper`.

        A spring and damper on the angle phi_b - phi_a; in space on the angle about marker a's z-axis.

        In space the angle is that of the joint between the two markers, or else one between -pi and pi.

        Parameters
        ----------
        name : str
            Name of the load, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.
        stiffness : float or expression
            Stiffness [N m/rad]; not negative.
        damping : float or expression, default 0.0
            Damping [N m s/rad]; not negative.
        free_angle : float or expression, default 0.0
            Angle without torque [rad].

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its generalised force is part of Q in the equations of motion (Eq. 22).
        """

    def spring_damper(
        self,
        name: str,
        marker_a: str,
        marker_b: str,
        stiffness: Quantity,
        *,
        damping: Quantity = ...,
        free_length: Quantity = ...,
    ) -> Self:
        """Add a load of the type `spring_damper`.

        A spring and damper along the line between two markers.

        Parameters
        ----------
        name : str
            Name of the load, by which expressions, results and messages refer to it.
        marker_a : str
            Marker a, `"body.marker"`.
        marker_b : str
            Marker b, `"body.marker"`.
        stiffness : float or expression
            Stiffness [N/m]; not negative.
        damping : float or expression, default 0.0
            Damping [N s/m]; not negative.
        free_length : float or expression, default 0.0
            Length without force [m]; not negative.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its generalised force is part of Q in the equations of motion (Eq. 22).
        """

    def torque(
        self,
        name: str,
        marker: str,
        value: Quantity,
        *,
        reaction: str | None = ...,
    ) -> Self:
        """Add a load of the type `torque`.

        A torque [N m] about a marker's z-axis, counter-clockwise; its opposite acts at ``reaction`` if given.

        Parameters
        ----------
        name : str
            Name of the load, by which expressions, results and messages refer to it.
        marker : str
            Marker about whose z-axis it acts, `"body.marker"`.
        value : float or expression
            Torque [N m]; expressions may use parameters, inputs, t, measures, states and their rates.
        reaction : str, optional
            Marker at which the opposite torque acts.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, a value too many, or a name that is not text; in `build` and `model` for
            what is missing and for values that cannot be used.

        Notes
        -----
        Its generalised force is part of Q in the equations of motion (Eq. 22).
        """
