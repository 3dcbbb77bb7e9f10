"""Spin-up of a rotating beam (F3): equations of motion, emitted by symgen from the scene `spin_up_beam`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.

q_i, the independent coordinates by index:
    0 beam.q1 [m], 1 beam.q2 [m], 2 beam.q3 [m], 3 beam.q4 [m], 4 beam.q5 [m]

q_d, the dependent coordinates by index:
    0 beam.x [m], 1 beam.y [m], 2 beam.theta [rad]
"""

import casadi as ca


def constants() -> ca.Function:
    """Everything that depends on the parameters p only.

    takes p (n_p = 654) [SI]: parameters: every physical number of a scene that is not zero
    gives c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    153 operations.
    """
    p = ca.SX.sym("p", 654)
    omega = p[0]
    ramp = p[1]
    beam_length = p[2]
    beam_density = p[3]
    beam_area = p[4]
    beam_youngs_modulus = p[5]
    beam_second_moment = p[6]
    beam_clamped_free5_kappa_lateral_0_0 = p[7]
    beam_clamped_free5_kappa_lateral_1_1 = p[8]
    beam_clamped_free5_kappa_lateral_2_2 = p[9]
    beam_clamped_free5_kappa_lateral_3_3 = p[10]
    beam_clamped_free5_kappa_lateral_4_4 = p[11]
    beam_clamped_free5_mass_0_0 = p[12]
    beam_clamped_free5_mass_1_1 = p[13]
    beam_clamped_free5_mass_2_2 = p[14]
    beam_clamped_free5_mass_3_3 = p[15]
    beam_clamped_free5_mass_4_4 = p[16]
    beam_clamped_free5_s1_0_0 = p[17]
    beam_clamped_free5_i0_0_0 = p[18]
    beam_clamped_free5_phi_y_0_0 = p[19]
    beam_clamped_free5_phi_y_1_0 = p[20]
    beam_clamped_free5_phi_y_2_0 = p[21]
    beam_clamped_free5_phi_y_3_0 = p[22]
    beam_clamped_free5_phi_y_4_0 = p[23]
    beam_clamped_free5_xi_phi_y_0_0 = p[24]
    beam_clamped_free5_xi_phi_y_1_0 = p[25]
    beam_clamped_free5_xi_phi_y_2_0 = p[26]
    beam_clamped_free5_xi_phi_y_3_0 = p[27]
    beam_clamped_free5_xi_phi_y_4_0 = p[28]
    beam_clamped_free5_H_0_0 = p[29]
    beam_clamped_free5_H_0_1 = p[30]
    beam_clamped_free5_H_0_2 = p[31]
    beam_clamped_free5_H_0_3 = p[32]
    beam_clamped_free5_H_0_4 = p[33]
    beam_clamped_free5_H_1_0 = p[34]
    beam_clamped_free5_H_1_1 = p[35]
    beam_clamped_free5_H_1_2 = p[36]
    beam_clamped_free5_H_1_3 = p[37]
    beam_clamped_free5_H_1_4 = p[38]
    beam_clamped_free5_H_2_0 = p[39]
    beam_clamped_free5_H_2_1 = p[40]
    beam_clamped_free5_H_2_2 = p[41]
    beam_clamped_free5_H_2_3 = p[42]
    beam_clamped_free5_H_2_4 = p[43]
    beam_clamped_free5_H_3_0 = p[44]
    beam_clamped_free5_H_3_1 = p[45]
    beam_clamped_free5_H_3_2 = p[46]
    beam_clamped_free5_H_3_3 = p[47]
    beam_clamped_free5_H_3_4 = p[48]
    beam_clamped_free5_H_4_0 = p[49]
    beam_clamped_free5_H_4_1 = p[50]
    beam_clamped_free5_H_4_2 = p[51]
    beam_clamped_free5_H_4_3 = p[52]
    beam_clamped_free5_H_4_4 = p[53]
    beam_clamped_free5_xH_0_0 = p[54]
    beam_clamped_free5_xH_0_1 = p[55]
    beam_clamped_free5_xH_0_2 = p[56]
    beam_clamped_free5_xH_0_3 = p[57]
    beam_clamped_free5_xH_0_4 = p[58]
    beam_clamped_free5_xH_1_0 = p[59]
    beam_clamped_free5_xH_1_1 = p[60]
    beam_clamped_free5_xH_1_2 = p[61]
    beam_clamped_free5_xH_1_3 = p[62]
    beam_clamped_free5_xH_1_4 = p[63]
    beam_clamped_free5_xH_2_0 = p[64]
    beam_clamped_free5_xH_2_1 = p[65]
    beam_clamped_free5_xH_2_2 = p[66]
    beam_clamped_free5_xH_2_3 = p[67]
    beam_clamped_free5_xH_2_4 = p[68]
    beam_clamped_free5_xH_3_0 = p[69]
    beam_clamped_free5_xH_3_1 = p[70]
    beam_clamped_free5_xH_3_2 = p[71]
    beam_clamped_free5_xH_3_3 = p[72]
    beam_clamped_free5_xH_3_4 = p[73]
    beam_clamped_free5_xH_4_0 = p[74]
    beam_clamped_free5_xH_4_1 = p[75]
    beam_clamped_free5_xH_4_2 = p[76]
    beam_clamped_free5_xH_4_3 = p[77]
    beam_clamped_free5_xH_4_4 = p[78]
    beam_clamped_free5_1_0_shape_1_0 = p[79]
    beam_clamped_free5_1_0_shape_1_1 = p[80]
    beam_clamped_free5_1_0_shape_1_2 = p[81]
    beam_clamped_free5_1_0_shape_1_3 = p[82]
    beam_clamped_free5_1_0_shape_1_4 = p[83]
    beam_clamped_free5_1_0_H_0_0 = p[89]
    beam_clamped_free5_1_0_H_0_1 = p[90]
    beam_clamped_free5_1_0_H_0_2 = p[91]
    beam_clamped_free5_1_0_H_0_3 = p[92]
    beam_clamped_free5_1_0_H_0_4 = p[93]
    beam_clamped_free5_1_0_H_1_0 = p[94]
    beam_clamped_free5_1_0_H_1_1 = p[95]
    beam_clamped_free5_1_0_H_1_2 = p[96]
    beam_clamped_free5_1_0_H_1_3 = p[97]
    beam_clamped_free5_1_0_H_1_4 = p[98]
    beam_clamped_free5_1_0_H_2_0 = p[99]
    beam_clamped_free5_1_0_H_2_1 = p[100]
    beam_clamped_free5_1_0_H_2_2 = p[101]
    beam_clamped_free5_1_0_H_2_3 = p[102]
    beam_clamped_free5_1_0_H_2_4 = p[103]
    beam_clamped_free5_1_0_H_3_0 = p[104]
    beam_clamped_free5_1_0_H_3_1 = p[105]
    beam_clamped_free5_1_0_H_3_2 = p[106]
    beam_clamped_free5_1_0_H_3_3 = p[107]
    beam_clamped_free5_1_0_H_3_4 = p[108]
    beam_clamped_free5_1_0_H_4_0 = p[109]
    beam_clamped_free5_1_0_H_4_1 = p[110]
    beam_clamped_free5_1_0_H_4_2 = p[111]
    beam_clamped_free5_1_0_H_4_3 = p[112]
    beam_clamped_free5_1_0_H_4_4 = p[113]
    # intermediate terms (47)
    w0 = beam_density * beam_area
    w1 = w0 * beam_length
    w2 = w1 * beam_clamped_free5_mass_0_0
    w3 = w1 * beam_clamped_free5_mass_1_1
    w4 = w1 * beam_clamped_free5_mass_2_2
    w5 = w1 * beam_clamped_free5_mass_3_3
    w6 = w1 * beam_clamped_free5_mass_4_4
    w7 = w1 * beam_clamped_free5_xH_0_0
    w8 = w1 * beam_clamped_free5_xH_0_1
    w9 = w1 * beam_clamped_free5_xH_0_2
    w10 = w1 * beam_clamped_free5_xH_0_3
    w11 = w1 * beam_clamped_free5_xH_0_4
    w12 = beam_length**2
    w13 = beam_youngs_modulus * beam_second_moment / (beam_length * w12)
    w14 = beam_length * w1
    w15 = w14 * beam_clamped_free5_xi_phi_y_0_0
    w16 = (ramp / 6.283185307179586)**2
    w17 = 6.283185307179586 / ramp
    w18 = w1 * beam_clamped_free5_xH_1_0
    w19 = w1 * beam_clamped_free5_xH_1_1
    w20 = w1 * beam_clamped_free5_xH_1_2
    w21 = w1 * beam_clamped_free5_xH_1_3
    w22 = w1 * beam_clamped_free5_xH_1_4
    w23 = w14 * beam_clamped_free5_xi_phi_y_1_0
    w24 = w1 * beam_clamped_free5_xH_2_0
    w25 = w1 * beam_clamped_free5_xH_2_1
    w26 = w1 * beam_clamped_free5_xH_2_2
    w27 = w1 * beam_clamped_free5_xH_2_3
    w28 = w1 * beam_clamped_free5_xH_2_4
    w29 = w14 * beam_clamped_free5_xi_phi_y_2_0
    w30 = w1 * beam_clamped_free5_xH_3_0
    w31 = w1 * beam_clamped_free5_xH_3_1
    w32 = w1 * beam_clamped_free5_xH_3_2
    w33 = w1 * beam_clamped_free5_xH_3_3
    w34 = w1 * beam_clamped_free5_xH_3_4
    w35 = w14 * beam_clamped_free5_xi_phi_y_3_0
    w36 = w1 * beam_clamped_free5_xH_4_0
    w37 = w1 * beam_clamped_free5_xH_4_1
    w38 = w1 * beam_clamped_free5_xH_4_2
    w39 = w1 * beam_clamped_free5_xH_4_3
    w40 = w1 * beam_clamped_free5_xH_4_4
    w41 = w14 * beam_clamped_free5_xi_phi_y_4_0
    w42 = w1 * beam_clamped_free5_phi_y_0_0
    w43 = w1 * beam_clamped_free5_phi_y_1_0
    w44 = w1 * beam_clamped_free5_phi_y_2_0
    w45 = w1 * beam_clamped_free5_phi_y_3_0
    w46 = w1 * beam_clamped_free5_phi_y_4_0
    # outputs
    c = ca.vertcat(
        w2,  # c0
        w3,  # c1
        w4,  # c2
        w5,  # c3
        w6,  # c4
        w7,  # c5
        w8,  # c6
        w9,  # c7
        w10,  # c8
        w11,  # c9
        w13 * beam_clamped_free5_kappa_lateral_0_0,  # c10
        ramp,  # ramp
        w15,  # c12
        omega / ramp,  # c13
        w16 * w17**2,  # c14
        w18,  # c15
        w19,  # c16
        w20,  # c17
        w21,  # c18
        w22,  # c19
        w13 * beam_clamped_free5_kappa_lateral_1_1,  # c20
        w23,  # c21
        w24,  # c22
        w25,  # c23
        w26,  # c24
        w27,  # c25
        w28,  # c26
        w13 * beam_clamped_free5_kappa_lateral_2_2,  # c27
        w29,  # c28
        w30,  # c29
        w31,  # c30
        w32,  # c31
        w33,  # c32
        w34,  # c33
        w13 * beam_clamped_free5_kappa_lateral_3_3,  # c34
        w35,  # c35
        w36,  # c36
        w37,  # c37
        w38,  # c38
        w39,  # c39
        w40,  # c40
        w13 * beam_clamped_free5_kappa_lateral_4_4,  # c41
        w41,  # c42
        omega,  # omega
        w16,  # c44
        ramp / 2.0,  # c45
        w16 * w17,  # c46
        w1,  # c47
        w14 * beam_clamped_free5_s1_0_0,  # c48
        w0 * beam_clamped_free5_H_0_0,  # c49
        w0 * beam_clamped_free5_H_0_1,  # c50
        w0 * beam_clamped_free5_H_0_2,  # c51
        w0 * beam_clamped_free5_H_0_3,  # c52
        w0 * beam_clamped_free5_H_0_4,  # c53
        w0 * beam_clamped_free5_H_1_0,  # c54
        w0 * beam_clamped_free5_H_1_1,  # c55
        w0 * beam_clamped_free5_H_1_2,  # c56
        w0 * beam_clamped_free5_H_1_3,  # c57
        w0 * beam_clamped_free5_H_1_4,  # c58
        w0 * beam_clamped_free5_H_2_0,  # c59
        w0 * beam_clamped_free5_H_2_1,  # c60
        w0 * beam_clamped_free5_H_2_2,  # c61
        w0 * beam_clamped_free5_H_2_3,  # c62
        w0 * beam_clamped_free5_H_2_4,  # c63
        w0 * beam_clamped_free5_H_3_0,  # c64
        w0 * beam_clamped_free5_H_3_1,  # c65
        w0 * beam_clamped_free5_H_3_2,  # c66
        w0 * beam_clamped_free5_H_3_3,  # c67
        w0 * beam_clamped_free5_H_3_4,  # c68
        w0 * beam_clamped_free5_H_4_0,  # c69
        w0 * beam_clamped_free5_H_4_1,  # c70
        w0 * beam_clamped_free5_H_4_2,  # c71
        w0 * beam_clamped_free5_H_4_3,  # c72
        w0 * beam_clamped_free5_H_4_4,  # c73
        w42,  # c74
        w43,  # c75
        w44,  # c76
        w45,  # c77
        w46,  # c78
        w1 * w12 * beam_clamped_free5_i0_0_0,  # c79
        -w42,  # c80
        -w43,  # c81
        -w44,  # c82
        -w45,  # c83
        -w46,  # c84
        beam_length,  # beam_length
        beam_clamped_free5_1_0_H_0_0 / beam_length,  # c86
        beam_clamped_free5_1_0_H_0_1 / beam_length,  # c87
        beam_clamped_free5_1_0_H_0_2 / beam_length,  # c88
        beam_clamped_free5_1_0_H_0_3 / beam_length,  # c89
        beam_clamped_free5_1_0_H_0_4 / beam_length,  # c90
        beam_clamped_free5_1_0_H_1_0 / beam_length,  # c91
        beam_clamped_free5_1_0_H_1_1 / beam_length,  # c92
        beam_clamped_free5_1_0_H_1_2 / beam_length,  # c93
        beam_clamped_free5_1_0_H_1_3 / beam_length,  # c94
        beam_clamped_free5_1_0_H_1_4 / beam_length,  # c95
        beam_clamped_free5_1_0_H_2_0 / beam_length,  # c96
        beam_clamped_free5_1_0_H_2_1 / beam_length,  # c97
        beam_clamped_free5_1_0_H_2_2 / beam_length,  # c98
        beam_clamped_free5_1_0_H_2_3 / beam_length,  # c99
        beam_clamped_free5_1_0_H_2_4 / beam_length,  # c100
        beam_clamped_free5_1_0_H_3_0 / beam_length,  # c101
        beam_clamped_free5_1_0_H_3_1 / beam_length,  # c102
        beam_clamped_free5_1_0_H_3_2 / beam_length,  # c103
        beam_clamped_free5_1_0_H_3_3 / beam_length,  # c104
        beam_clamped_free5_1_0_H_3_4 / beam_length,  # c105
        beam_clamped_free5_1_0_H_4_0 / beam_length,  # c106
        beam_clamped_free5_1_0_H_4_1 / beam_length,  # c107
        beam_clamped_free5_1_0_H_4_2 / beam_length,  # c108
        beam_clamped_free5_1_0_H_4_3 / beam_length,  # c109
        beam_clamped_free5_1_0_H_4_4 / beam_length,  # c110
        beam_clamped_free5_1_0_shape_1_0,  # beam_clamped_free5_1_0_shape_1_0
        beam_clamped_free5_1_0_shape_1_1,  # beam_clamped_free5_1_0_shape_1_1
        beam_clamped_free5_1_0_shape_1_2,  # beam_clamped_free5_1_0_shape_1_2
        beam_clamped_free5_1_0_shape_1_3,  # beam_clamped_free5_1_0_shape_1_3
        beam_clamped_free5_1_0_shape_1_4,  # beam_clamped_free5_1_0_shape_1_4
        w2 - w7,  # c116
        -w18,  # c117
        -w24,  # c118
        -w30,  # c119
        -w36,  # c120
        -w8,  # c121
        w3 - w19,  # c122
        -w25,  # c123
        -w31,  # c124
        -w37,  # c125
        -w9,  # c126
        -w20,  # c127
        w4 - w26,  # c128
        -w32,  # c129
        -w38,  # c130
        -w10,  # c131
        -w21,  # c132
        -w27,  # c133
        w5 - w33,  # c134
        -w39,  # c135
        -w11,  # c136
        -w22,  # c137
        -w28,  # c138
        -w34,  # c139
        w6 - w40,  # c140
        -(w15 / w2),  # c141
        -(w23 / w3),  # c142
        -(w29 / w4),  # c143
        -(w35 / w5),  # c144
        -(w41 / w6),  # c145
    )
    inputs, outputs = [p], [ca.densify(c)]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """Condensed mass matrix and force (Eq. 38).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d_dot (n_d = 3) [mixed]: rates of the dependent coordinates
    takes t (1) [s]: time
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M_hat (n_i x n_i = 5 x 5) [SI]: condensed mass matrix S^T M S
    gives Q_hat (n_i = 5) [N, N m]: condensed force S^T (Q* - M s)
    93 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 3)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 146)
    beam_q1 = q_i[0]
    beam_q2 = q_i[1]
    beam_q3 = q_i[2]
    beam_q4 = q_i[3]
    beam_q5 = q_i[4]
    beam_theta_dot = q_d_dot[2]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    ramp = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    # intermediate terms (8)
    w0 = beam_theta_dot**2
    w1 = w0 * (beam_q1 * c0 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7 + beam_q4 * c8 + beam_q5 * c9)) - beam_q1 * c10
    w2 = t < ramp
    w3 = (1.0 - ca.cos(t * 6.283185307179586 / ramp) * c14) * c13
    w4 = w0 * (beam_q2 * c1 - (beam_q1 * c15 + beam_q2 * c16 + beam_q3 * c17 + beam_q4 * c18 + beam_q5 * c19))
    w5 = w0 * (beam_q3 * c2 - (beam_q1 * c22 + beam_q2 * c23 + beam_q3 * c24 + beam_q4 * c25 + beam_q5 * c26))
    w6 = w0 * (beam_q4 * c3 - (beam_q1 * c29 + beam_q2 * c30 + beam_q3 * c31 + beam_q4 * c32 + beam_q5 * c33))
    w7 = w0 * (beam_q5 * c4 - (beam_q1 * c36 + beam_q2 * c37 + beam_q3 * c38 + beam_q4 * c39 + beam_q5 * c40))
    # outputs
    M_hat = ca.SX(5, 5)
    # beam.q1
    M_hat[0, 0] = c0
    # beam.q2
    M_hat[1, 1] = c1
    # beam.q3
    M_hat[2, 2] = c2
    # beam.q4
    M_hat[3, 3] = c3
    # beam.q5
    M_hat[4, 4] = c4
    Q_hat = ca.vertcat(
        w1 - ca.if_else(w2, w3 * c12, 0),  # beam.q1
        w4 - beam_q2 * c20 - ca.if_else(w2, w3 * c21, 0),  # beam.q2
        w5 - beam_q3 * c27 - ca.if_else(w2, w3 * c28, 0),  # beam.q3
        w6 - beam_q4 * c34 - ca.if_else(w2, w3 * c35, 0),  # beam.q4
        w7 - beam_q5 * c41 - ca.if_else(w2, w3 * c42, 0),  # beam.q5
    )
    inputs, outputs = [q_i, q_d_dot, t, c], [ca.densify(M_hat), ca.densify(Q_hat)]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d_dot", "t", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d; C_loop before the step (Eq. 31).

    takes t (1) [s]: time
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_next (n_d = 3) [mixed]: dependent coordinates after one Newton step
    16 operations.
    """
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 146)
    ramp = c[11]
    c13 = c[13]
    omega = c[43]
    c44 = c[44]
    c45 = c[45]
    # intermediate terms (2)
    w0 = t < ramp
    w1 = ca.if_else(w0, (t**2 / 2.0 + (ca.cos(t * 6.283185307179586 / ramp) - 1.0) * c44) * c13, 0) + ca.if_else(ca.logic_not(w0), (t - c45) * omega, 0)
    # outputs
    q_d_next = ca.vertcat(0.0, 0.0, w1)
    inputs, outputs = [t, c], [ca.densify(q_d_next)]
    return ca.Function("closure", inputs, outputs, ["t", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """Rates of the dependent coordinates (Eq. 36).

    takes t (1) [s]: time
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_dot (n_d = 3) [mixed]: rates of the dependent coordinates
    11 operations.
    """
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 146)
    ramp = c[11]
    c13 = c[13]
    omega = c[43]
    c46 = c[46]
    # intermediate terms (2)
    w0 = t < ramp
    w1 = ca.if_else(w0, (t - ca.sin(t * 6.283185307179586 / ramp) * c46) * c13, 0) + ca.if_else(ca.logic_not(w0), omega, 0)
    # outputs
    q_d_dot = ca.vertcat(0.0, 0.0, w1)
    inputs, outputs = [t, c], [ca.densify(q_d_dot)]
    return ca.Function("velocities", inputs, outputs, ["t", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """Accelerations of the dependent coordinates (Eq. 35).

    takes t (1) [s]: time
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_d_ddot (n_d = 3) [mixed]: accelerations of the dependent coordinates
    8 operations.
    """
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 146)
    ramp = c[11]
    c13 = c[13]
    c14 = c[14]
    # outputs
    q_d_ddot = ca.vertcat(0.0, 0.0, ca.if_else(t < ramp, (1.0 - ca.cos(t * 6.283185307179586 / ramp) * c14) * c13, 0))
    inputs, outputs = [t, c], [ca.densify(q_d_ddot)]
    return ca.Function("accelerations", inputs, outputs, ["t", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """Constraints and their derivatives in all coordinates (Eqs. 21-27).

    takes q (n = 8) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes t (1) [s]: time
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives C (n_c = 3) [m, rad]: constraint rows C(q, t) = 0 in scene order
    gives C_q (n_c x n = 3 x 8) [SI]: constraint Jacobian
    gives C_t (n_c = 3) [m/s, rad/s]: partial time derivative of C (prescribed motions)
    gives nu (n_c = 3) [m/s, rad/s]: right-hand side at velocity level, nu = -C_t
    gives gamma (n_c = 3) [m/s^2, rad/s^2]: right-hand side at acceleration level
    29 operations.
    """
    q = ca.SX.sym("q", 8)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 146)
    beam_x = q[0]
    beam_y = q[1]
    beam_theta = q[2]
    ramp = c[11]
    c13 = c[13]
    c14 = c[14]
    omega = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    # intermediate terms (6)
    w0 = t < ramp
    w1 = t * 6.283185307179586 / ramp
    w2 = ca.cos(w1)
    w3 = ca.logic_not(w0)
    w4 = beam_theta - (ca.if_else(w0, (t**2 / 2.0 + (w2 - 1.0) * c44) * c13, 0) + ca.if_else(w3, (t - c45) * omega, 0))
    w5 = ca.if_else(w0, (t - ca.sin(w1) * c46) * c13, 0) + ca.if_else(w3, omega, 0)
    # outputs
    C = ca.vertcat(beam_x, beam_y, w4)
    C_q = ca.SX(3, 8)
    # pivot.x
    C_q[0, 0] = 1.0
    # pivot.y
    C_q[1, 1] = 1.0
    # spin.angle
    C_q[2, 2] = 1.0
    C_t = ca.vertcat(0.0, 0.0, -w5)
    nu = ca.vertcat(0.0, 0.0, w5)
    gamma = ca.vertcat(0.0, 0.0, ca.if_else(w0, (1.0 - w2 * c14) * c13, 0))
    inputs, outputs = [q, t, c], [ca.densify(C), ca.densify(C_q), ca.densify(C_t), ca.densify(nu), ca.densify(gamma)]
    return ca.Function("constraints", inputs, outputs, ["q", "t", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """Parts of the augmented form; Q_star = Q_F + Q_v - K q (Eq. 28).

    takes q (n = 8) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 8) [mixed]: rates of all coordinates
    takes t (1) [s]: time
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives M (n x n = 8 x 8) [SI]: mass matrix in all coordinates
    gives K (n x n = 8 x 8) [SI]: stiffness matrix in all coordinates
    gives Q_v (n = 8) [N, N m]: quadratic velocity force in all coordinates
    gives Q_F (n = 8) [N, N m]: force of loads, weight and damping in all coordinates
    gives Q_star (n = 8) [N, N m]: generalised force Q_F + Q_v - K q in all coordinates
    gives C_q (n_c x n = 3 x 8) [SI]: constraint Jacobian
    gives gamma (n_c = 3) [m/s^2, rad/s^2]: right-hand side at acceleration level
    293 operations.
    """
    q = ca.SX.sym("q", 8)
    q_dot = ca.SX.sym("q_dot", 8)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 146)
    beam_theta = q[2]
    beam_q1 = q[3]
    beam_q2 = q[4]
    beam_q3 = q[5]
    beam_q4 = q[6]
    beam_q5 = q[7]
    beam_theta_dot = q_dot[2]
    beam_q1_dot = q_dot[3]
    beam_q2_dot = q_dot[4]
    beam_q3_dot = q_dot[5]
    beam_q4_dot = q_dot[6]
    beam_q5_dot = q_dot[7]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    ramp = c[11]
    c12 = c[12]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c47 = c[47]
    c48 = c[48]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c65 = c[65]
    c66 = c[66]
    c67 = c[67]
    c68 = c[68]
    c69 = c[69]
    c70 = c[70]
    c71 = c[71]
    c72 = c[72]
    c73 = c[73]
    c74 = c[74]
    c75 = c[75]
    c76 = c[76]
    c77 = c[77]
    c78 = c[78]
    c79 = c[79]
    c80 = c[80]
    c81 = c[81]
    c82 = c[82]
    c83 = c[83]
    c84 = c[84]
    # intermediate terms (46)
    w0 = ca.sin(beam_theta)
    w1 = beam_q1 * c49 + beam_q2 * c50 + beam_q3 * c51 + beam_q4 * c52 + beam_q5 * c53
    w2 = beam_q1 * c54 + beam_q2 * c55 + beam_q3 * c56 + beam_q4 * c57 + beam_q5 * c58
    w3 = beam_q1 * c59 + beam_q2 * c60 + beam_q3 * c61 + beam_q4 * c62 + beam_q5 * c63
    w4 = beam_q1 * c64 + beam_q2 * c65 + beam_q3 * c66 + beam_q4 * c67 + beam_q5 * c68
    w5 = beam_q1 * c69 + beam_q2 * c70 + beam_q3 * c71 + beam_q4 * c72 + beam_q5 * c73
    w6 = c48 - (beam_q1 * w1 + beam_q2 * w2 + beam_q3 * w3 + beam_q4 * w4 + beam_q5 * w5) * 0.5
    w7 = ca.cos(beam_theta)
    w8 = beam_q1 * c74 + beam_q2 * c75 + beam_q3 * c76 + beam_q4 * c77 + beam_q5 * c78
    w9 = w0 * w6 + w7 * w8
    w10 = -w9
    w11 = w6 * w7 - w0 * w8
    w12 = w7 * c74 - w0 * w1
    w13 = w7 * c75 - w0 * w2
    w14 = w7 * c76 - w0 * w3
    w15 = w7 * c77 - w0 * w4
    w16 = w7 * c78 - w0 * w5
    w17 = beam_q1 * c0 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7 + beam_q4 * c8 + beam_q5 * c9)
    w18 = beam_q2 * c1 - (beam_q1 * c15 + beam_q2 * c16 + beam_q3 * c17 + beam_q4 * c18 + beam_q5 * c19)
    w19 = beam_q3 * c2 - (beam_q1 * c22 + beam_q2 * c23 + beam_q3 * c24 + beam_q4 * c25 + beam_q5 * c26)
    w20 = beam_q4 * c3 - (beam_q1 * c29 + beam_q2 * c30 + beam_q3 * c31 + beam_q4 * c32 + beam_q5 * c33)
    w21 = beam_q5 * c4 - (beam_q1 * c36 + beam_q2 * c37 + beam_q3 * c38 + beam_q4 * c39 + beam_q5 * c40)
    w22 = beam_theta_dot**2
    w23 = 2 * beam_theta_dot
    w24 = beam_q1_dot * c74 + beam_q2_dot * c75 + beam_q3_dot * c76 + beam_q4_dot * c77 + beam_q5_dot * c78
    w25 = w1 * beam_q1_dot + w2 * beam_q2_dot + w3 * beam_q3_dot + w4 * beam_q4_dot + w5 * beam_q5_dot
    w26 = beam_q1_dot * c49 + beam_q2_dot * c50 + beam_q3_dot * c51 + beam_q4_dot * c52 + beam_q5_dot * c53
    w27 = beam_q1_dot * c54 + beam_q2_dot * c55 + beam_q3_dot * c56 + beam_q4_dot * c57 + beam_q5_dot * c58
    w28 = beam_q1_dot * c59 + beam_q2_dot * c60 + beam_q3_dot * c61 + beam_q4_dot * c62 + beam_q5_dot * c63
    w29 = beam_q1_dot * c64 + beam_q2_dot * c65 + beam_q3_dot * c66 + beam_q4_dot * c67 + beam_q5_dot * c68
    w30 = beam_q1_dot * c69 + beam_q2_dot * c70 + beam_q3_dot * c71 + beam_q4_dot * c72 + beam_q5_dot * c73
    w31 = beam_q1_dot * w26 + beam_q2_dot * w27 + beam_q3_dot * w28 + beam_q4_dot * w29 + beam_q5_dot * w30
    w32 = w11 * w22 + w23 * (w7 * w24 - w0 * w25) + w7 * w31
    w33 = w9 * w22 + w0 * w31 + w23 * (w7 * w25 + w0 * w24)
    w34 = w17 * beam_q1_dot + w18 * beam_q2_dot + w19 * beam_q3_dot + w20 * beam_q4_dot + w21 * beam_q5_dot
    w35 = beam_theta_dot * -2.0 * w34
    w36 = w17 * w22
    w37 = w18 * w22
    w38 = w19 * w22
    w39 = w20 * w22
    w40 = w21 * w22
    w41 = w0 * c80 - w1 * w7
    w42 = w0 * c81 - w2 * w7
    w43 = w0 * c82 - w3 * w7
    w44 = w0 * c83 - w4 * w7
    w45 = w0 * c84 - w5 * w7
    # outputs
    M = ca.SX(8, 8)
    # beam.x
    M[0, 0] = c47
    M[0, 2] = w10
    M[0, 3] = w41
    M[0, 4] = w42
    M[0, 5] = w43
    M[0, 6] = w44
    M[0, 7] = w45
    # beam.y
    M[1, 1] = c47
    M[1, 2] = w11
    M[1, 3] = w12
    M[1, 4] = w13
    M[1, 5] = w14
    M[1, 6] = w15
    M[1, 7] = w16
    # beam.theta
    M[2, 0] = w10
    M[2, 1] = w11
    M[2, 2] = c79 + (beam_q1 * w17 + beam_q2 * w18 + beam_q3 * w19 + beam_q4 * w20 + beam_q5 * w21)
    M[2, 3] = c12
    M[2, 4] = c21
    M[2, 5] = c28
    M[2, 6] = c35
    M[2, 7] = c42
    # beam.q1
    M[3, 0] = w41
    M[3, 1] = w12
    M[3, 2] = c12
    M[3, 3] = c0
    # beam.q2
    M[4, 0] = w42
    M[4, 1] = w13
    M[4, 2] = c21
    M[4, 4] = c1
    # beam.q3
    M[5, 0] = w43
    M[5, 1] = w14
    M[5, 2] = c28
    M[5, 5] = c2
    # beam.q4
    M[6, 0] = w44
    M[6, 1] = w15
    M[6, 2] = c35
    M[6, 6] = c3
    # beam.q5
    M[7, 0] = w45
    M[7, 1] = w16
    M[7, 2] = c42
    M[7, 7] = c4
    K = ca.SX(8, 8)
    # beam.q1
    K[3, 3] = c10
    # beam.q2
    K[4, 4] = c20
    # beam.q3
    K[5, 5] = c27
    # beam.q4
    K[6, 6] = c34
    # beam.q5
    K[7, 7] = c41
    Q_v = ca.vertcat(
        w32,  # beam.x
        w33,  # beam.y
        w35,  # beam.theta
        w36,  # beam.q1
        w37,  # beam.q2
        w38,  # beam.q3
        w39,  # beam.q4
        w40,  # beam.q5
    )
    Q_F = ca.SX(8, 1)
    Q_star = ca.vertcat(
        w32,  # beam.x
        w33,  # beam.y
        w35,  # beam.theta
        w36 - beam_q1 * c10,  # beam.q1
        w37 - beam_q2 * c20,  # beam.q2
        w38 - beam_q3 * c27,  # beam.q3
        w39 - beam_q4 * c34,  # beam.q4
        w40 - beam_q5 * c41,  # beam.q5
    )
    C_q = ca.SX(3, 8)
    # pivot.x
    C_q[0, 0] = 1.0
    # pivot.y
    C_q[1, 1] = 1.0
    # spin.angle
    C_q[2, 2] = 1.0
    gamma = ca.vertcat(0.0, 0.0, ca.if_else(t < ramp, (1.0 - ca.cos(t * 6.283185307179586 / ramp) * c14) * c13, 0))
    inputs, outputs = [q, q_dot, t, c], [ca.densify(M), ca.densify(K), ca.densify(Q_v), ca.densify(Q_F), ca.densify(Q_star), ca.densify(C_q), ca.densify(gamma)]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "t", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma"])


def reactions() -> ca.Function:
    """Multipliers, and what the joints do to their bodies b (Eq. 37).

    takes q (n = 8) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 8) [mixed]: rates of all coordinates
    takes q_ddot (n = 8) [mixed]: accelerations of all coordinates
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives lam (n_c = 3) [N, N m]: Lagrange multipliers; the constraint force on q is -C_q^T lam
    gives joint_forces (3 or 6 x joints = 3 x 2) [N, N m]: world force and moment of a joint on its body b, at b
    316 operations.
    """
    q = ca.SX.sym("q", 8)
    q_dot = ca.SX.sym("q_dot", 8)
    q_ddot = ca.SX.sym("q_ddot", 8)
    c = ca.SX.sym("c", 146)
    beam_theta = q[2]
    beam_q1 = q[3]
    beam_q2 = q[4]
    beam_q3 = q[5]
    beam_q4 = q[6]
    beam_q5 = q[7]
    beam_theta_dot = q_dot[2]
    beam_q1_dot = q_dot[3]
    beam_q2_dot = q_dot[4]
    beam_q3_dot = q_dot[5]
    beam_q4_dot = q_dot[6]
    beam_q5_dot = q_dot[7]
    beam_x_ddot = q_ddot[0]
    beam_y_ddot = q_ddot[1]
    beam_theta_ddot = q_ddot[2]
    beam_q1_ddot = q_ddot[3]
    beam_q2_ddot = q_ddot[4]
    beam_q3_ddot = q_ddot[5]
    beam_q4_ddot = q_ddot[6]
    beam_q5_ddot = q_ddot[7]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c12 = c[12]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c42 = c[42]
    c47 = c[47]
    c48 = c[48]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c65 = c[65]
    c66 = c[66]
    c67 = c[67]
    c68 = c[68]
    c69 = c[69]
    c70 = c[70]
    c71 = c[71]
    c72 = c[72]
    c73 = c[73]
    c74 = c[74]
    c75 = c[75]
    c76 = c[76]
    c77 = c[77]
    c78 = c[78]
    c79 = c[79]
    # intermediate terms (36)
    w0 = beam_theta_dot**2
    w1 = ca.cos(beam_theta)
    w2 = beam_q1 * c49 + beam_q2 * c50 + beam_q3 * c51 + beam_q4 * c52 + beam_q5 * c53
    w3 = beam_q1 * c54 + beam_q2 * c55 + beam_q3 * c56 + beam_q4 * c57 + beam_q5 * c58
    w4 = beam_q1 * c59 + beam_q2 * c60 + beam_q3 * c61 + beam_q4 * c62 + beam_q5 * c63
    w5 = beam_q1 * c64 + beam_q2 * c65 + beam_q3 * c66 + beam_q4 * c67 + beam_q5 * c68
    w6 = beam_q1 * c69 + beam_q2 * c70 + beam_q3 * c71 + beam_q4 * c72 + beam_q5 * c73
    w7 = c48 - (beam_q1 * w2 + beam_q2 * w3 + beam_q3 * w4 + beam_q4 * w5 + beam_q5 * w6) * 0.5
    w8 = ca.sin(beam_theta)
    w9 = beam_q1 * c74 + beam_q2 * c75 + beam_q3 * c76 + beam_q4 * c77 + beam_q5 * c78
    w10 = w1 * w7 - w8 * w9
    w11 = 2 * beam_theta_dot
    w12 = beam_q1_dot * c74 + beam_q2_dot * c75 + beam_q3_dot * c76 + beam_q4_dot * c77 + beam_q5_dot * c78
    w13 = w2 * beam_q1_dot + w3 * beam_q2_dot + w4 * beam_q3_dot + w5 * beam_q4_dot + w6 * beam_q5_dot
    w14 = beam_q1_dot * c49 + beam_q2_dot * c50 + beam_q3_dot * c51 + beam_q4_dot * c52 + beam_q5_dot * c53
    w15 = beam_q1_dot * c54 + beam_q2_dot * c55 + beam_q3_dot * c56 + beam_q4_dot * c57 + beam_q5_dot * c58
    w16 = beam_q1_dot * c59 + beam_q2_dot * c60 + beam_q3_dot * c61 + beam_q4_dot * c62 + beam_q5_dot * c63
    w17 = beam_q1_dot * c64 + beam_q2_dot * c65 + beam_q3_dot * c66 + beam_q4_dot * c67 + beam_q5_dot * c68
    w18 = beam_q1_dot * c69 + beam_q2_dot * c70 + beam_q3_dot * c71 + beam_q4_dot * c72 + beam_q5_dot * c73
    w19 = beam_q1_dot * w14 + beam_q2_dot * w15 + beam_q3_dot * w16 + beam_q4_dot * w17 + beam_q5_dot * w18
    w20 = w7 * w8 + w1 * w9
    w21 = beam_x_ddot * c47 - w20 * beam_theta_ddot - (w1 * w2 + w8 * c74) * beam_q1_ddot - (w1 * w3 + w8 * c75) * beam_q2_ddot
    w22 = w21 - (w1 * w4 + w8 * c76) * beam_q3_ddot - (w1 * w5 + w8 * c77) * beam_q4_ddot - (w1 * w6 + w8 * c78) * beam_q5_ddot
    w23 = w0 * w10 + w11 * (w1 * w12 - w8 * w13) + w1 * w19 - w22
    w24 = beam_y_ddot * c47 + w10 * beam_theta_ddot + beam_q1_ddot * (w1 * c74 - w2 * w8) + beam_q2_ddot * (w1 * c75 - w3 * w8)
    w25 = w24 + beam_q3_ddot * (w1 * c76 - w4 * w8) + beam_q4_ddot * (w1 * c77 - w5 * w8) + beam_q5_ddot * (w1 * c78 - w6 * w8)
    w26 = w0 * w20 + w8 * w19 + w11 * (w1 * w13 + w8 * w12) - w25
    w27 = beam_q1 * c0 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7 + beam_q4 * c8 + beam_q5 * c9)
    w28 = beam_q2 * c1 - (beam_q1 * c15 + beam_q2 * c16 + beam_q3 * c17 + beam_q4 * c18 + beam_q5 * c19)
    w29 = beam_q3 * c2 - (beam_q1 * c22 + beam_q2 * c23 + beam_q3 * c24 + beam_q4 * c25 + beam_q5 * c26)
    w30 = beam_q4 * c3 - (beam_q1 * c29 + beam_q2 * c30 + beam_q3 * c31 + beam_q4 * c32 + beam_q5 * c33)
    w31 = beam_q5 * c4 - (beam_q1 * c36 + beam_q2 * c37 + beam_q3 * c38 + beam_q4 * c39 + beam_q5 * c40)
    w32 = beam_q1_dot * w27 + beam_q2_dot * w28 + beam_q3_dot * w29 + beam_q4_dot * w30 + beam_q5_dot * w31
    w33 = beam_theta_ddot * (c79 + (beam_q1 * w27 + beam_q2 * w28 + beam_q3 * w29 + beam_q4 * w30 + beam_q5 * w31))
    w34 = w10 * beam_y_ddot - beam_x_ddot * w20 + w33 + beam_q1_ddot * c12 + beam_q2_ddot * c21 + beam_q3_ddot * c28
    w35 = beam_theta_dot * -2.0 * w32 - (w34 + beam_q4_ddot * c35 + beam_q5_ddot * c42)
    # outputs
    lam = ca.vertcat(w23, w26, w35)
    joint_forces = ca.SX(3, 2)
    joint_forces[0, 0] = -w23
    joint_forces[1, 0] = -w26
    joint_forces[2, 1] = -w35
    inputs, outputs = [q, q_dot, q_ddot, c], [ca.densify(lam), ca.densify(joint_forces)]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies and powers.

    takes q (n = 8) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 8) [mixed]: rates of all coordinates
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives kinetic (1) [J]: kinetic energy
    gives elastic (1) [J]: energy stored in bodies and springs
    gives potential (1) [J]: potential energy of the weight
    gives power_dissipated (1) [W]: power lost in dampers, at least zero
    gives power_applied (1) [W]: power of the loads
    275 operations.
    """
    q = ca.SX.sym("q", 8)
    q_dot = ca.SX.sym("q_dot", 8)
    c = ca.SX.sym("c", 146)
    beam_theta = q[2]
    beam_q1 = q[3]
    beam_q2 = q[4]
    beam_q3 = q[5]
    beam_q4 = q[6]
    beam_q5 = q[7]
    beam_x_dot = q_dot[0]
    beam_y_dot = q_dot[1]
    beam_theta_dot = q_dot[2]
    beam_q1_dot = q_dot[3]
    beam_q2_dot = q_dot[4]
    beam_q3_dot = q_dot[5]
    beam_q4_dot = q_dot[6]
    beam_q5_dot = q_dot[7]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c12 = c[12]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c21 = c[21]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c47 = c[47]
    c48 = c[48]
    c49 = c[49]
    c50 = c[50]
    c51 = c[51]
    c52 = c[52]
    c53 = c[53]
    c54 = c[54]
    c55 = c[55]
    c56 = c[56]
    c57 = c[57]
    c58 = c[58]
    c59 = c[59]
    c60 = c[60]
    c61 = c[61]
    c62 = c[62]
    c63 = c[63]
    c64 = c[64]
    c65 = c[65]
    c66 = c[66]
    c67 = c[67]
    c68 = c[68]
    c69 = c[69]
    c70 = c[70]
    c71 = c[71]
    c72 = c[72]
    c73 = c[73]
    c74 = c[74]
    c75 = c[75]
    c76 = c[76]
    c77 = c[77]
    c78 = c[78]
    c79 = c[79]
    # intermediate terms (37)
    w0 = ca.sin(beam_theta)
    w1 = beam_q1 * c49 + beam_q2 * c50 + beam_q3 * c51 + beam_q4 * c52 + beam_q5 * c53
    w2 = beam_q1 * c54 + beam_q2 * c55 + beam_q3 * c56 + beam_q4 * c57 + beam_q5 * c58
    w3 = beam_q1 * c59 + beam_q2 * c60 + beam_q3 * c61 + beam_q4 * c62 + beam_q5 * c63
    w4 = beam_q1 * c64 + beam_q2 * c65 + beam_q3 * c66 + beam_q4 * c67 + beam_q5 * c68
    w5 = beam_q1 * c69 + beam_q2 * c70 + beam_q3 * c71 + beam_q4 * c72 + beam_q5 * c73
    w6 = c48 - (beam_q1 * w1 + beam_q2 * w2 + beam_q3 * w3 + beam_q4 * w4 + beam_q5 * w5) * 0.5
    w7 = ca.cos(beam_theta)
    w8 = beam_q1 * c74 + beam_q2 * c75 + beam_q3 * c76 + beam_q4 * c77 + beam_q5 * c78
    w9 = w0 * w6 + w7 * w8
    w10 = w1 * w7 + w0 * c74
    w11 = w2 * w7 + w0 * c75
    w12 = w3 * w7 + w0 * c76
    w13 = beam_x_dot * c47 - w9 * beam_theta_dot - w10 * beam_q1_dot - w11 * beam_q2_dot - w12 * beam_q3_dot
    w14 = w4 * w7 + w0 * c77
    w15 = w5 * w7 + w0 * c78
    w16 = w6 * w7 - w0 * w8
    w17 = w7 * c74 - w0 * w1
    w18 = w7 * c75 - w0 * w2
    w19 = w7 * c76 - w0 * w3
    w20 = beam_y_dot * c47 + beam_theta_dot * w16 + beam_q1_dot * w17 + beam_q2_dot * w18 + beam_q3_dot * w19
    w21 = w7 * c77 - w0 * w4
    w22 = w7 * c78 - w0 * w5
    w23 = beam_x_dot * (w13 - w14 * beam_q4_dot - w15 * beam_q5_dot) + beam_y_dot * (w20 + beam_q4_dot * w21 + beam_q5_dot * w22)
    w24 = beam_q1 * (beam_q1 * c0 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7 + beam_q4 * c8 + beam_q5 * c9))
    w25 = beam_q2 * (beam_q2 * c1 - (beam_q1 * c15 + beam_q2 * c16 + beam_q3 * c17 + beam_q4 * c18 + beam_q5 * c19))
    w26 = beam_q3 * (beam_q3 * c2 - (beam_q1 * c22 + beam_q2 * c23 + beam_q3 * c24 + beam_q4 * c25 + beam_q5 * c26))
    w27 = beam_q4 * (beam_q4 * c3 - (beam_q1 * c29 + beam_q2 * c30 + beam_q3 * c31 + beam_q4 * c32 + beam_q5 * c33))
    w28 = beam_q5 * (beam_q5 * c4 - (beam_q1 * c36 + beam_q2 * c37 + beam_q3 * c38 + beam_q4 * c39 + beam_q5 * c40))
    w29 = beam_y_dot * w16 - beam_x_dot * w9 + beam_theta_dot * (c79 + (w24 + w25 + w26 + w27 + w28)) + beam_q1_dot * c12
    w30 = beam_theta_dot * (w29 + beam_q2_dot * c21 + beam_q3_dot * c28 + beam_q4_dot * c35 + beam_q5_dot * c42)
    w31 = w23 + w30 + beam_q1_dot * (beam_y_dot * w17 - beam_x_dot * w10 + beam_theta_dot * c12 + beam_q1_dot * c0)
    w32 = w31 + beam_q2_dot * (beam_y_dot * w18 - beam_x_dot * w11 + beam_theta_dot * c21 + beam_q2_dot * c1)
    w33 = w32 + beam_q3_dot * (beam_y_dot * w19 - beam_x_dot * w12 + beam_theta_dot * c28 + beam_q3_dot * c2)
    w34 = w33 + beam_q4_dot * (beam_y_dot * w21 - beam_x_dot * w14 + beam_theta_dot * c35 + beam_q4_dot * c3)
    w35 = w34 + beam_q5_dot * (beam_y_dot * w22 - beam_x_dot * w15 + beam_theta_dot * c42 + beam_q5_dot * c4)
    w36 = beam_q1 * (beam_q1 * c10) + beam_q2 * (beam_q2 * c20) + beam_q3 * (beam_q3 * c27) + beam_q4 * (beam_q4 * c34)
    # outputs
    kinetic = ca.vertcat(w35 / 2.0)
    elastic = ca.vertcat((w36 + beam_q5 * (beam_q5 * c41)) / 2.0)
    potential = ca.SX(1, 1)
    power_dissipated = ca.SX(1, 1)
    power_applied = ca.SX(1, 1)
    inputs, outputs = [q, q_dot, c], [ca.densify(kinetic), ca.densify(elastic), ca.densify(potential), ca.densify(power_dissipated), ca.densify(power_applied)]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def measures() -> ca.Function:
    """The scene's measures and their rates.

    takes q (n = 8) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    takes q_dot (n = 8) [mixed]: rates of all coordinates
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives measures (measures = 4) [mixed]: measures of the scene and their rates
    167 operations.
    """
    q = ca.SX.sym("q", 8)
    q_dot = ca.SX.sym("q_dot", 8)
    c = ca.SX.sym("c", 146)
    beam_x = q[0]
    beam_y = q[1]
    beam_theta = q[2]
    beam_q1 = q[3]
    beam_q2 = q[4]
    beam_q3 = q[5]
    beam_q4 = q[6]
    beam_q5 = q[7]
    beam_x_dot = q_dot[0]
    beam_y_dot = q_dot[1]
    beam_theta_dot = q_dot[2]
    beam_q1_dot = q_dot[3]
    beam_q2_dot = q_dot[4]
    beam_q3_dot = q_dot[5]
    beam_q4_dot = q_dot[6]
    beam_q5_dot = q_dot[7]
    beam_length = c[85]
    c86 = c[86]
    c87 = c[87]
    c88 = c[88]
    c89 = c[89]
    c90 = c[90]
    c91 = c[91]
    c92 = c[92]
    c93 = c[93]
    c94 = c[94]
    c95 = c[95]
    c96 = c[96]
    c97 = c[97]
    c98 = c[98]
    c99 = c[99]
    c100 = c[100]
    c101 = c[101]
    c102 = c[102]
    c103 = c[103]
    c104 = c[104]
    c105 = c[105]
    c106 = c[106]
    c107 = c[107]
    c108 = c[108]
    c109 = c[109]
    c110 = c[110]
    beam_clamped_free5_1_0_shape_1_0 = c[111]
    beam_clamped_free5_1_0_shape_1_1 = c[112]
    beam_clamped_free5_1_0_shape_1_2 = c[113]
    beam_clamped_free5_1_0_shape_1_3 = c[114]
    beam_clamped_free5_1_0_shape_1_4 = c[115]
    # intermediate terms (21)
    w0 = ca.cos(beam_theta)
    w1 = beam_q1 * c86 + beam_q2 * c87 + beam_q3 * c88 + beam_q4 * c89 + beam_q5 * c90
    w2 = beam_q1 * c91 + beam_q2 * c92 + beam_q3 * c93 + beam_q4 * c94 + beam_q5 * c95
    w3 = beam_q1 * c96 + beam_q2 * c97 + beam_q3 * c98 + beam_q4 * c99 + beam_q5 * c100
    w4 = beam_q1 * c101 + beam_q2 * c102 + beam_q3 * c103 + beam_q4 * c104 + beam_q5 * c105
    w5 = beam_q1 * c106 + beam_q2 * c107 + beam_q3 * c108 + beam_q4 * c109 + beam_q5 * c110
    w6 = beam_length - (beam_q1 * w1 + beam_q2 * w2 + beam_q3 * w3 + beam_q4 * w4 + beam_q5 * w5) * 0.5
    w7 = ca.sin(beam_theta)
    w8 = beam_q1 * beam_clamped_free5_1_0_shape_1_0 + beam_q2 * beam_clamped_free5_1_0_shape_1_1 + beam_q3 * beam_clamped_free5_1_0_shape_1_2
    w9 = w8 + beam_q4 * beam_clamped_free5_1_0_shape_1_3 + beam_q5 * beam_clamped_free5_1_0_shape_1_4
    w10 = w7 * beam_theta_dot
    w11 = beam_q1_dot * c86 + beam_q2_dot * c87 + beam_q3_dot * c88 + beam_q4_dot * c89 + beam_q5_dot * c90
    w12 = beam_q1_dot * c91 + beam_q2_dot * c92 + beam_q3_dot * c93 + beam_q4_dot * c94 + beam_q5_dot * c95
    w13 = beam_q1_dot * c96 + beam_q2_dot * c97 + beam_q3_dot * c98 + beam_q4_dot * c99 + beam_q5_dot * c100
    w14 = w1 * beam_q1_dot + beam_q1 * w11 + (w2 * beam_q2_dot + beam_q2 * w12) + (w3 * beam_q3_dot + beam_q3 * w13)
    w15 = beam_q1_dot * c101 + beam_q2_dot * c102 + beam_q3_dot * c103 + beam_q4_dot * c104 + beam_q5_dot * c105
    w16 = beam_q1_dot * c106 + beam_q2_dot * c107 + beam_q3_dot * c108 + beam_q4_dot * c109 + beam_q5_dot * c110
    w17 = (w14 + (w4 * beam_q4_dot + beam_q4 * w15) + (w5 * beam_q5_dot + beam_q5 * w16)) * 0.5
    w18 = w0 * beam_theta_dot
    w19 = beam_q1_dot * beam_clamped_free5_1_0_shape_1_0 + beam_q2_dot * beam_clamped_free5_1_0_shape_1_1 + beam_q3_dot * beam_clamped_free5_1_0_shape_1_2
    w20 = w19 + beam_q4_dot * beam_clamped_free5_1_0_shape_1_3 + beam_q5_dot * beam_clamped_free5_1_0_shape_1_4
    # outputs
    measures = ca.vertcat(
        beam_x + (w0 * w6 - w7 * w9),  # tip_x
        beam_x_dot - (w6 * w10 + w0 * w17 + (w9 * w18 + w7 * w20)),  # tip_x_dot
        beam_y + (w6 * w7 + w0 * w9),  # tip_y
        beam_y_dot + (w6 * w18 - w7 * w17 + (w0 * w20 - w9 * w10)),  # tip_y_dot
    )
    inputs, outputs = [q, q_dot, c], [ca.densify(measures)]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot", "c"], ["measures"])


def poses() -> ca.Function:
    """Origin and rotation matrix of each body, for pictures.

    takes q (n = 8) [mixed]: all coordinates: R_o, theta, q_f of each body in scene order
    gives poses (12 x bodies = 12) [m, 1]: origin, then columns of the rotation matrix, of each body that moves
    3 operations.
    """
    q = ca.SX.sym("q", 8)
    beam_x = q[0]
    beam_y = q[1]
    beam_theta = q[2]
    # intermediate terms (2)
    w0 = ca.cos(beam_theta)
    w1 = ca.sin(beam_theta)
    # outputs
    poses = ca.SX(12, 1)
    poses[0] = beam_x
    poses[1] = beam_y
    poses[3] = w0
    poses[4] = w1
    poses[6] = -w1
    poses[7] = w0
    poses[11] = 1.0
    inputs, outputs = [q], [ca.densify(poses)]
    return ca.Function("poses", inputs, outputs, ["q"], ["poses"])


def switching() -> ca.Function:
    """Where in time loads and prescribed motions jump or kink: where one of these changes its sign.

    takes t (1) [s]: time
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives switching (conditions in t = 1) [SI]: zero where a load or a prescribed motion jumps or kinks
    1 operations.
    """
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 146)
    ramp = c[11]
    # outputs
    switching = ca.vertcat(t - ramp)
    inputs, outputs = [t, c], [ca.densify(switching)]
    return ca.Function("switching", inputs, outputs, ["t", "c"], ["switching"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t).

    takes q_d_dot (n_d = 3) [mixed]: rates of the dependent coordinates
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives dQ_hat_dq_i (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat by q_i, through q_d
    31 operations.
    """
    q_d_dot = ca.SX.sym("q_d_dot", 3)
    c = ca.SX.sym("c", 146)
    beam_theta_dot = q_d_dot[2]
    c10 = c[10]
    c20 = c[20]
    c27 = c[27]
    c34 = c[34]
    c41 = c[41]
    c116 = c[116]
    c117 = c[117]
    c118 = c[118]
    c119 = c[119]
    c120 = c[120]
    c121 = c[121]
    c122 = c[122]
    c123 = c[123]
    c124 = c[124]
    c125 = c[125]
    c126 = c[126]
    c127 = c[127]
    c128 = c[128]
    c129 = c[129]
    c130 = c[130]
    c131 = c[131]
    c132 = c[132]
    c133 = c[133]
    c134 = c[134]
    c135 = c[135]
    c136 = c[136]
    c137 = c[137]
    c138 = c[138]
    c139 = c[139]
    c140 = c[140]
    # intermediate terms (1)
    w0 = beam_theta_dot**2
    # outputs
    dQ_hat_dq_i = ca.vertcat(
        ca.horzcat(w0 * c116 - c10, w0 * c121, w0 * c126, w0 * c131, w0 * c136),  # beam.q1
        ca.horzcat(w0 * c117, w0 * c122 - c20, w0 * c127, w0 * c132, w0 * c137),  # beam.q2
        ca.horzcat(w0 * c118, w0 * c123, w0 * c128 - c27, w0 * c133, w0 * c138),  # beam.q3
        ca.horzcat(w0 * c119, w0 * c124, w0 * c129, w0 * c134 - c34, w0 * c139),  # beam.q4
        ca.horzcat(w0 * c120, w0 * c125, w0 * c130, w0 * c135, w0 * c140 - c41),  # beam.q5
    )
    inputs, outputs = [q_d_dot, c], [ca.densify(dQ_hat_dq_i)]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot.

    gives dQ_hat_dq_i_dot (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat by q_i_dot, through q_d_dot
    0 operations.
    """
    # outputs
    dQ_hat_dq_i_dot = ca.SX(5, 5)
    inputs, outputs = [], [ca.densify(dQ_hat_dq_i_dot)]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, [], ["dQ_hat_dq_i_dot"])


def residual_jacobian() -> ca.Function:
    """Total derivatives of Q_hat - M_hat q_i_ddot by q_i and by q_i_dot at fixed q_i_ddot.

    takes q_d_dot (n_d = 3) [mixed]: rates of the dependent coordinates
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives J_q (n_i x n_i = 5 x 5) [SI]: total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot
    gives J_v (n_i x n_i = 5 x 5) [SI]: the same as dQ_hat_dq_i_dot, in a linear system
    31 operations.
    """
    q_d_dot = ca.SX.sym("q_d_dot", 3)
    c = ca.SX.sym("c", 146)
    beam_theta_dot = q_d_dot[2]
    c10 = c[10]
    c20 = c[20]
    c27 = c[27]
    c34 = c[34]
    c41 = c[41]
    c116 = c[116]
    c117 = c[117]
    c118 = c[118]
    c119 = c[119]
    c120 = c[120]
    c121 = c[121]
    c122 = c[122]
    c123 = c[123]
    c124 = c[124]
    c125 = c[125]
    c126 = c[126]
    c127 = c[127]
    c128 = c[128]
    c129 = c[129]
    c130 = c[130]
    c131 = c[131]
    c132 = c[132]
    c133 = c[133]
    c134 = c[134]
    c135 = c[135]
    c136 = c[136]
    c137 = c[137]
    c138 = c[138]
    c139 = c[139]
    c140 = c[140]
    # intermediate terms (1)
    w0 = beam_theta_dot**2
    # outputs
    J_q = ca.vertcat(
        ca.horzcat(w0 * c116 - c10, w0 * c121, w0 * c126, w0 * c131, w0 * c136),  # beam.q1
        ca.horzcat(w0 * c117, w0 * c122 - c20, w0 * c127, w0 * c132, w0 * c137),  # beam.q2
        ca.horzcat(w0 * c118, w0 * c123, w0 * c128 - c27, w0 * c133, w0 * c138),  # beam.q3
        ca.horzcat(w0 * c119, w0 * c124, w0 * c129, w0 * c134 - c34, w0 * c139),  # beam.q4
        ca.horzcat(w0 * c120, w0 * c125, w0 * c130, w0 * c135, w0 * c140 - c41),  # beam.q5
    )
    J_v = ca.SX(5, 5)
    inputs, outputs = [q_d_dot, c], [ca.densify(J_q), ca.densify(J_v)]
    return ca.Function("residual_jacobian", inputs, outputs, ["q_d_dot", "c"], ["J_q", "J_v"])


def deflections() -> ca.Function:
    """Stiff deflections s = B^T q_i, and the stiffness and damping between them.

    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives B (n_i x n_s = 5 x 5) [1]: stiff deflections s = B^T q_i: modes, springs between coordinates
    gives K_s (n_s x n_s = 5 x 5) [SI]: stiffness of the stiff deflections
    gives D_s (n_s x n_s = 5 x 5) [SI]: damping of the stiff deflections
    0 operations.
    """
    c = ca.SX.sym("c", 146)
    c10 = c[10]
    c20 = c[20]
    c27 = c[27]
    c34 = c[34]
    c41 = c[41]
    # outputs
    B = ca.SX(5, 5)
    # beam.q1
    B[0, 0] = 1.0
    # beam.q2
    B[1, 1] = 1.0
    # beam.q3
    B[2, 2] = 1.0
    # beam.q4
    B[3, 3] = 1.0
    # beam.q5
    B[4, 4] = 1.0
    K_s = ca.SX(5, 5)
    K_s[0, 0] = c10
    K_s[1, 1] = c20
    K_s[2, 2] = c27
    K_s[3, 3] = c34
    K_s[4, 4] = c41
    D_s = ca.SX(5, 5)
    inputs, outputs = [c], [ca.densify(B), ca.densify(K_s), ca.densify(D_s)]
    return ca.Function("deflections", inputs, outputs, ["c"], ["B", "K_s", "D_s"])


def forward_dynamics() -> ca.Function:
    """Accelerations of a tree by topology-ordered elimination, without M_hat (Eq. 38).

    takes q_i (n_i = 5) [mixed]: independent coordinates, in the order of the partition
    takes q_d_dot (n_d = 3) [mixed]: rates of the dependent coordinates
    takes t (1) [s]: time
    takes c (n_const = 146) [SI]: what depends on p only, computed once a run: c = constants(p)
    gives q_i_ddot (n_i = 5) [mixed]: accelerations of the independent coordinates
    98 operations.
    """
    q_i = ca.SX.sym("q_i", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 3)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 146)
    beam_q1 = q_i[0]
    beam_q2 = q_i[1]
    beam_q3 = q_i[2]
    beam_q4 = q_i[3]
    beam_q5 = q_i[4]
    beam_theta_dot = q_d_dot[2]
    c0 = c[0]
    c1 = c[1]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    ramp = c[11]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c22 = c[22]
    c23 = c[23]
    c24 = c[24]
    c25 = c[25]
    c26 = c[26]
    c27 = c[27]
    c29 = c[29]
    c30 = c[30]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c141 = c[141]
    c142 = c[142]
    c143 = c[143]
    c144 = c[144]
    c145 = c[145]
    # intermediate terms (8)
    w0 = beam_theta_dot**2
    w1 = w0 * (beam_q1 * c0 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7 + beam_q4 * c8 + beam_q5 * c9)) - beam_q1 * c10
    w2 = t < ramp
    w3 = (1.0 - ca.cos(t * 6.283185307179586 / ramp) * c14) * c13
    w4 = w0 * (beam_q2 * c1 - (beam_q1 * c15 + beam_q2 * c16 + beam_q3 * c17 + beam_q4 * c18 + beam_q5 * c19))
    w5 = w0 * (beam_q3 * c2 - (beam_q1 * c22 + beam_q2 * c23 + beam_q3 * c24 + beam_q4 * c25 + beam_q5 * c26))
    w6 = w0 * (beam_q4 * c3 - (beam_q1 * c29 + beam_q2 * c30 + beam_q3 * c31 + beam_q4 * c32 + beam_q5 * c33))
    w7 = w0 * (beam_q5 * c4 - (beam_q1 * c36 + beam_q2 * c37 + beam_q3 * c38 + beam_q4 * c39 + beam_q5 * c40))
    # outputs
    q_i_ddot = ca.vertcat(
        w1 / c0 + ca.if_else(w2, w3 * c141, 0),  # beam.q1
        (w4 - beam_q2 * c20) / c1 + ca.if_else(w2, w3 * c142, 0),  # beam.q2
        (w5 - beam_q3 * c27) / c2 + ca.if_else(w2, w3 * c143, 0),  # beam.q3
        (w6 - beam_q4 * c34) / c3 + ca.if_else(w2, w3 * c144, 0),  # beam.q4
        (w7 - beam_q5 * c41) / c4 + ca.if_else(w2, w3 * c145, 0),  # beam.q5
    )
    inputs, outputs = [q_i, q_d_dot, t, c], [ca.densify(q_i_ddot)]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_d_dot", "t", "c"], ["q_i_ddot"])


def geometry() -> ca.Function:
    """Points of the bodies as functions of the parameters, for pictures.

    takes p (n_p = 654) [SI]: parameters: every physical number of a scene that is not zero
    gives positions (3 x points = 3 x 20) [m]: drawn points in body axes
    gives axes (9 x points = 9 x 20) [1]: columns of the rotation matrix of the marker at a drawn point
    gives shapes (3 x modes = 3 x 95) [1]: displacement of a drawn point by each mode of its body
    gives turns (3 x modes = 3 x 95) [1/m]: rotation at a drawn point by each mode of its body
    gives H (1 x entries = 1 x 425) [1/m]: foreshortening of the drawn points that have it, nf x nf each
    gives sections (2 x beams = 2) [m]: height and width of a rectangle that stands for a beam's section
    gives rigidities (2 x beams = 2) [N m^2]: E I of a beam for bending along y and along z
    500 operations.
    """
    p = ca.SX.sym("p", 654)
    beam_length = p[2]
    beam_area = p[4]
    beam_youngs_modulus = p[5]
    beam_second_moment = p[6]
    beam_clamped_free5_1_0_shape_1_0 = p[79]
    beam_clamped_free5_1_0_shape_1_1 = p[80]
    beam_clamped_free5_1_0_shape_1_2 = p[81]
    beam_clamped_free5_1_0_shape_1_3 = p[82]
    beam_clamped_free5_1_0_shape_1_4 = p[83]
    beam_clamped_free5_1_0_slope_0_0 = p[84]
    beam_clamped_free5_1_0_slope_1_0 = p[85]
    beam_clamped_free5_1_0_slope_2_0 = p[86]
    beam_clamped_free5_1_0_slope_3_0 = p[87]
    beam_clamped_free5_1_0_slope_4_0 = p[88]
    beam_clamped_free5_1_0_H_0_0 = p[89]
    beam_clamped_free5_1_0_H_0_1 = p[90]
    beam_clamped_free5_1_0_H_0_2 = p[91]
    beam_clamped_free5_1_0_H_0_3 = p[92]
    beam_clamped_free5_1_0_H_0_4 = p[93]
    beam_clamped_free5_1_0_H_1_0 = p[94]
    beam_clamped_free5_1_0_H_1_1 = p[95]
    beam_clamped_free5_1_0_H_1_2 = p[96]
    beam_clamped_free5_1_0_H_1_3 = p[97]
    beam_clamped_free5_1_0_H_1_4 = p[98]
    beam_clamped_free5_1_0_H_2_0 = p[99]
    beam_clamped_free5_1_0_H_2_1 = p[100]
    beam_clamped_free5_1_0_H_2_2 = p[101]
    beam_clamped_free5_1_0_H_2_3 = p[102]
    beam_clamped_free5_1_0_H_2_4 = p[103]
    beam_clamped_free5_1_0_H_3_0 = p[104]
    beam_clamped_free5_1_0_H_3_1 = p[105]
    beam_clamped_free5_1_0_H_3_2 = p[106]
    beam_clamped_free5_1_0_H_3_3 = p[107]
    beam_clamped_free5_1_0_H_3_4 = p[108]
    beam_clamped_free5_1_0_H_4_0 = p[109]
    beam_clamped_free5_1_0_H_4_1 = p[110]
    beam_clamped_free5_1_0_H_4_2 = p[111]
    beam_clamped_free5_1_0_H_4_3 = p[112]
    beam_clamped_free5_1_0_H_4_4 = p[113]
    beam_clamped_free5_0_0625_at_0_0 = p[114]
    beam_clamped_free5_0_0625_shape_1_0 = p[115]
    beam_clamped_free5_0_0625_shape_1_1 = p[116]
    beam_clamped_free5_0_0625_shape_1_2 = p[117]
    beam_clamped_free5_0_0625_shape_1_3 = p[118]
    beam_clamped_free5_0_0625_shape_1_4 = p[119]
    beam_clamped_free5_0_0625_slope_0_0 = p[120]
    beam_clamped_free5_0_0625_slope_1_0 = p[121]
    beam_clamped_free5_0_0625_slope_2_0 = p[122]
    beam_clamped_free5_0_0625_slope_3_0 = p[123]
    beam_clamped_free5_0_0625_slope_4_0 = p[124]
    beam_clamped_free5_0_0625_H_0_0 = p[125]
    beam_clamped_free5_0_0625_H_0_1 = p[126]
    beam_clamped_free5_0_0625_H_0_2 = p[127]
    beam_clamped_free5_0_0625_H_0_3 = p[128]
    beam_clamped_free5_0_0625_H_0_4 = p[129]
    beam_clamped_free5_0_0625_H_1_0 = p[130]
    beam_clamped_free5_0_0625_H_1_1 = p[131]
    beam_clamped_free5_0_0625_H_1_2 = p[132]
    beam_clamped_free5_0_0625_H_1_3 = p[133]
    beam_clamped_free5_0_0625_H_1_4 = p[134]
    beam_clamped_free5_0_0625_H_2_0 = p[135]
    beam_clamped_free5_0_0625_H_2_1 = p[136]
    beam_clamped_free5_0_0625_H_2_2 = p[137]
    beam_clamped_free5_0_0625_H_2_3 = p[138]
    beam_clamped_free5_0_0625_H_2_4 = p[139]
    beam_clamped_free5_0_0625_H_3_0 = p[140]
    beam_clamped_free5_0_0625_H_3_1 = p[141]
    beam_clamped_free5_0_0625_H_3_2 = p[142]
    beam_clamped_free5_0_0625_H_3_3 = p[143]
    beam_clamped_free5_0_0625_H_3_4 = p[144]
    beam_clamped_free5_0_0625_H_4_0 = p[145]
    beam_clamped_free5_0_0625_H_4_1 = p[146]
    beam_clamped_free5_0_0625_H_4_2 = p[147]
    beam_clamped_free5_0_0625_H_4_3 = p[148]
    beam_clamped_free5_0_0625_H_4_4 = p[149]
    beam_clamped_free5_0_125_at_0_0 = p[150]
    beam_clamped_free5_0_125_shape_1_0 = p[151]
    beam_clamped_free5_0_125_shape_1_1 = p[152]
    beam_clamped_free5_0_125_shape_1_2 = p[153]
    beam_clamped_free5_0_125_shape_1_3 = p[154]
    beam_clamped_free5_0_125_shape_1_4 = p[155]
    beam_clamped_free5_0_125_slope_0_0 = p[156]
    beam_clamped_free5_0_125_slope_1_0 = p[157]
    beam_clamped_free5_0_125_slope_2_0 = p[158]
    beam_clamped_free5_0_125_slope_3_0 = p[159]
    beam_clamped_free5_0_125_slope_4_0 = p[160]
    beam_clamped_free5_0_125_H_0_0 = p[161]
    beam_clamped_free5_0_125_H_0_1 = p[162]
    beam_clamped_free5_0_125_H_0_2 = p[163]
    beam_clamped_free5_0_125_H_0_3 = p[164]
    beam_clamped_free5_0_125_H_0_4 = p[165]
    beam_clamped_free5_0_125_H_1_0 = p[166]
    beam_clamped_free5_0_125_H_1_1 = p[167]
    beam_clamped_free5_0_125_H_1_2 = p[168]
    beam_clamped_free5_0_125_H_1_3 = p[169]
    beam_clamped_free5_0_125_H_1_4 = p[170]
    beam_clamped_free5_0_125_H_2_0 = p[171]
    beam_clamped_free5_0_125_H_2_1 = p[172]
    beam_clamped_free5_0_125_H_2_2 = p[173]
    beam_clamped_free5_0_125_H_2_3 = p[174]
    beam_clamped_free5_0_125_H_2_4 = p[175]
    beam_clamped_free5_0_125_H_3_0 = p[176]
    beam_clamped_free5_0_125_H_3_1 = p[177]
    beam_clamped_free5_0_125_H_3_2 = p[178]
    beam_clamped_free5_0_125_H_3_3 = p[179]
    beam_clamped_free5_0_125_H_3_4 = p[180]
    beam_clamped_free5_0_125_H_4_0 = p[181]
    beam_clamped_free5_0_125_H_4_1 = p[182]
    beam_clamped_free5_0_125_H_4_2 = p[183]
    beam_clamped_free5_0_125_H_4_3 = p[184]
    beam_clamped_free5_0_125_H_4_4 = p[185]
    beam_clamped_free5_0_1875_at_0_0 = p[186]
    beam_clamped_free5_0_1875_shape_1_0 = p[187]
    beam_clamped_free5_0_1875_shape_1_1 = p[188]
    beam_clamped_free5_0_1875_shape_1_2 = p[189]
    beam_clamped_free5_0_1875_shape_1_3 = p[190]
    beam_clamped_free5_0_1875_shape_1_4 = p[191]
    beam_clamped_free5_0_1875_slope_0_0 = p[192]
    beam_clamped_free5_0_1875_slope_1_0 = p[193]
    beam_clamped_free5_0_1875_slope_2_0 = p[194]
    beam_clamped_free5_0_1875_slope_3_0 = p[195]
    beam_clamped_free5_0_1875_slope_4_0 = p[196]
    beam_clamped_free5_0_1875_H_0_0 = p[197]
    beam_clamped_free5_0_1875_H_0_1 = p[198]
    beam_clamped_free5_0_1875_H_0_2 = p[199]
    beam_clamped_free5_0_1875_H_0_3 = p[200]
    beam_clamped_free5_0_1875_H_0_4 = p[201]
    beam_clamped_free5_0_1875_H_1_0 = p[202]
    beam_clamped_free5_0_1875_H_1_1 = p[203]
    beam_clamped_free5_0_1875_H_1_2 = p[204]
    beam_clamped_free5_0_1875_H_1_3 = p[205]
    beam_clamped_free5_0_1875_H_1_4 = p[206]
    beam_clamped_free5_0_1875_H_2_0 = p[207]
    beam_clamped_free5_0_1875_H_2_1 = p[208]
    beam_clamped_free5_0_1875_H_2_2 = p[209]
    beam_clamped_free5_0_1875_H_2_3 = p[210]
    beam_clamped_free5_0_1875_H_2_4 = p[211]
    beam_clamped_free5_0_1875_H_3_0 = p[212]
    beam_clamped_free5_0_1875_H_3_1 = p[213]
    beam_clamped_free5_0_1875_H_3_2 = p[214]
    beam_clamped_free5_0_1875_H_3_3 = p[215]
    beam_clamped_free5_0_1875_H_3_4 = p[216]
    beam_clamped_free5_0_1875_H_4_0 = p[217]
    beam_clamped_free5_0_1875_H_4_1 = p[218]
    beam_clamped_free5_0_1875_H_4_2 = p[219]
    beam_clamped_free5_0_1875_H_4_3 = p[220]
    beam_clamped_free5_0_1875_H_4_4 = p[221]
    beam_clamped_free5_0_25_at_0_0 = p[222]
    beam_clamped_free5_0_25_shape_1_0 = p[223]
    beam_clamped_free5_0_25_shape_1_1 = p[224]
    beam_clamped_free5_0_25_shape_1_2 = p[225]
    beam_clamped_free5_0_25_shape_1_3 = p[226]
    beam_clamped_free5_0_25_shape_1_4 = p[227]
    beam_clamped_free5_0_25_slope_0_0 = p[228]
    beam_clamped_free5_0_25_slope_1_0 = p[229]
    beam_clamped_free5_0_25_slope_2_0 = p[230]
    beam_clamped_free5_0_25_slope_3_0 = p[231]
    beam_clamped_free5_0_25_slope_4_0 = p[232]
    beam_clamped_free5_0_25_H_0_0 = p[233]
    beam_clamped_free5_0_25_H_0_1 = p[234]
    beam_clamped_free5_0_25_H_0_2 = p[235]
    beam_clamped_free5_0_25_H_0_3 = p[236]
    beam_clamped_free5_0_25_H_0_4 = p[237]
    beam_clamped_free5_0_25_H_1_0 = p[238]
    beam_clamped_free5_0_25_H_1_1 = p[239]
    beam_clamped_free5_0_25_H_1_2 = p[240]
    beam_clamped_free5_0_25_H_1_3 = p[241]
    beam_clamped_free5_0_25_H_1_4 = p[242]
    beam_clamped_free5_0_25_H_2_0 = p[243]
    beam_clamped_free5_0_25_H_2_1 = p[244]
    beam_clamped_free5_0_25_H_2_2 = p[245]
    beam_clamped_free5_0_25_H_2_3 = p[246]
    beam_clamped_free5_0_25_H_2_4 = p[247]
    beam_clamped_free5_0_25_H_3_0 = p[248]
    beam_clamped_free5_0_25_H_3_1 = p[249]
    beam_clamped_free5_0_25_H_3_2 = p[250]
    beam_clamped_free5_0_25_H_3_3 = p[251]
    beam_clamped_free5_0_25_H_3_4 = p[252]
    beam_clamped_free5_0_25_H_4_0 = p[253]
    beam_clamped_free5_0_25_H_4_1 = p[254]
    beam_clamped_free5_0_25_H_4_2 = p[255]
    beam_clamped_free5_0_25_H_4_3 = p[256]
    beam_clamped_free5_0_25_H_4_4 = p[257]
    beam_clamped_free5_0_3125_at_0_0 = p[258]
    beam_clamped_free5_0_3125_shape_1_0 = p[259]
    beam_clamped_free5_0_3125_shape_1_1 = p[260]
    beam_clamped_free5_0_3125_shape_1_2 = p[261]
    beam_clamped_free5_0_3125_shape_1_3 = p[262]
    beam_clamped_free5_0_3125_shape_1_4 = p[263]
    beam_clamped_free5_0_3125_slope_0_0 = p[264]
    beam_clamped_free5_0_3125_slope_1_0 = p[265]
    beam_clamped_free5_0_3125_slope_2_0 = p[266]
    beam_clamped_free5_0_3125_slope_3_0 = p[267]
    beam_clamped_free5_0_3125_slope_4_0 = p[268]
    beam_clamped_free5_0_3125_H_0_0 = p[269]
    beam_clamped_free5_0_3125_H_0_1 = p[270]
    beam_clamped_free5_0_3125_H_0_2 = p[271]
    beam_clamped_free5_0_3125_H_0_3 = p[272]
    beam_clamped_free5_0_3125_H_0_4 = p[273]
    beam_clamped_free5_0_3125_H_1_0 = p[274]
    beam_clamped_free5_0_3125_H_1_1 = p[275]
    beam_clamped_free5_0_3125_H_1_2 = p[276]
    beam_clamped_free5_0_3125_H_1_3 = p[277]
    beam_clamped_free5_0_3125_H_1_4 = p[278]
    beam_clamped_free5_0_3125_H_2_0 = p[279]
    beam_clamped_free5_0_3125_H_2_1 = p[280]
    beam_clamped_free5_0_3125_H_2_2 = p[281]
    beam_clamped_free5_0_3125_H_2_3 = p[282]
    beam_clamped_free5_0_3125_H_2_4 = p[283]
    beam_clamped_free5_0_3125_H_3_0 = p[284]
    beam_clamped_free5_0_3125_H_3_1 = p[285]
    beam_clamped_free5_0_3125_H_3_2 = p[286]
    beam_clamped_free5_0_3125_H_3_3 = p[287]
    beam_clamped_free5_0_3125_H_3_4 = p[288]
    beam_clamped_free5_0_3125_H_4_0 = p[289]
    beam_clamped_free5_0_3125_H_4_1 = p[290]
    beam_clamped_free5_0_3125_H_4_2 = p[291]
    beam_clamped_free5_0_3125_H_4_3 = p[292]
    beam_clamped_free5_0_3125_H_4_4 = p[293]
    beam_clamped_free5_0_375_at_0_0 = p[294]
    beam_clamped_free5_0_375_shape_1_0 = p[295]
    beam_clamped_free5_0_375_shape_1_1 = p[296]
    beam_clamped_free5_0_375_shape_1_2 = p[297]
    beam_clamped_free5_0_375_shape_1_3 = p[298]
    beam_clamped_free5_0_375_shape_1_4 = p[299]
    beam_clamped_free5_0_375_slope_0_0 = p[300]
    beam_clamped_free5_0_375_slope_1_0 = p[301]
    beam_clamped_free5_0_375_slope_2_0 = p[302]
    beam_clamped_free5_0_375_slope_3_0 = p[303]
    beam_clamped_free5_0_375_slope_4_0 = p[304]
    beam_clamped_free5_0_375_H_0_0 = p[305]
    beam_clamped_free5_0_375_H_0_1 = p[306]
    beam_clamped_free5_0_375_H_0_2 = p[307]
    beam_clamped_free5_0_375_H_0_3 = p[308]
    beam_clamped_free5_0_375_H_0_4 = p[309]
    beam_clamped_free5_0_375_H_1_0 = p[310]
    beam_clamped_free5_0_375_H_1_1 = p[311]
    beam_clamped_free5_0_375_H_1_2 = p[312]
    beam_clamped_free5_0_375_H_1_3 = p[313]
    beam_clamped_free5_0_375_H_1_4 = p[314]
    beam_clamped_free5_0_375_H_2_0 = p[315]
    beam_clamped_free5_0_375_H_2_1 = p[316]
    beam_clamped_free5_0_375_H_2_2 = p[317]
    beam_clamped_free5_0_375_H_2_3 = p[318]
    beam_clamped_free5_0_375_H_2_4 = p[319]
    beam_clamped_free5_0_375_H_3_0 = p[320]
    beam_clamped_free5_0_375_H_3_1 = p[321]
    beam_clamped_free5_0_375_H_3_2 = p[322]
    beam_clamped_free5_0_375_H_3_3 = p[323]
    beam_clamped_free5_0_375_H_3_4 = p[324]
    beam_clamped_free5_0_375_H_4_0 = p[325]
    beam_clamped_free5_0_375_H_4_1 = p[326]
    beam_clamped_free5_0_375_H_4_2 = p[327]
    beam_clamped_free5_0_375_H_4_3 = p[328]
    beam_clamped_free5_0_375_H_4_4 = p[329]
    beam_clamped_free5_0_4375_at_0_0 = p[330]
    beam_clamped_free5_0_4375_shape_1_0 = p[331]
    beam_clamped_free5_0_4375_shape_1_1 = p[332]
    beam_clamped_free5_0_4375_shape_1_2 = p[333]
    beam_clamped_free5_0_4375_shape_1_3 = p[334]
    beam_clamped_free5_0_4375_shape_1_4 = p[335]
    beam_clamped_free5_0_4375_slope_0_0 = p[336]
    beam_clamped_free5_0_4375_slope_1_0 = p[337]
    beam_clamped_free5_0_4375_slope_2_0 = p[338]
    beam_clamped_free5_0_4375_slope_3_0 = p[339]
    beam_clamped_free5_0_4375_slope_4_0 = p[340]
    beam_clamped_free5_0_4375_H_0_0 = p[341]
    beam_clamped_free5_0_4375_H_0_1 = p[342]
    beam_clamped_free5_0_4375_H_0_2 = p[343]
    beam_clamped_free5_0_4375_H_0_3 = p[344]
    beam_clamped_free5_0_4375_H_0_4 = p[345]
    beam_clamped_free5_0_4375_H_1_0 = p[346]
    beam_clamped_free5_0_4375_H_1_1 = p[347]
    beam_clamped_free5_0_4375_H_1_2 = p[348]
    beam_clamped_free5_0_4375_H_1_3 = p[349]
    beam_clamped_free5_0_4375_H_1_4 = p[350]
    beam_clamped_free5_0_4375_H_2_0 = p[351]
    beam_clamped_free5_0_4375_H_2_1 = p[352]
    beam_clamped_free5_0_4375_H_2_2 = p[353]
    beam_clamped_free5_0_4375_H_2_3 = p[354]
    beam_clamped_free5_0_4375_H_2_4 = p[355]
    beam_clamped_free5_0_4375_H_3_0 = p[356]
    beam_clamped_free5_0_4375_H_3_1 = p[357]
    beam_clamped_free5_0_4375_H_3_2 = p[358]
    beam_clamped_free5_0_4375_H_3_3 = p[359]
    beam_clamped_free5_0_4375_H_3_4 = p[360]
    beam_clamped_free5_0_4375_H_4_0 = p[361]
    beam_clamped_free5_0_4375_H_4_1 = p[362]
    beam_clamped_free5_0_4375_H_4_2 = p[363]
    beam_clamped_free5_0_4375_H_4_3 = p[364]
    beam_clamped_free5_0_4375_H_4_4 = p[365]
    beam_clamped_free5_0_5_at_0_0 = p[366]
    beam_clamped_free5_0_5_shape_1_0 = p[367]
    beam_clamped_free5_0_5_shape_1_1 = p[368]
    beam_clamped_free5_0_5_shape_1_2 = p[369]
    beam_clamped_free5_0_5_shape_1_3 = p[370]
    beam_clamped_free5_0_5_shape_1_4 = p[371]
    beam_clamped_free5_0_5_slope_0_0 = p[372]
    beam_clamped_free5_0_5_slope_1_0 = p[373]
    beam_clamped_free5_0_5_slope_2_0 = p[374]
    beam_clamped_free5_0_5_slope_3_0 = p[375]
    beam_clamped_free5_0_5_slope_4_0 = p[376]
    beam_clamped_free5_0_5_H_0_0 = p[377]
    beam_clamped_free5_0_5_H_0_1 = p[378]
    beam_clamped_free5_0_5_H_0_2 = p[379]
    beam_clamped_free5_0_5_H_0_3 = p[380]
    beam_clamped_free5_0_5_H_0_4 = p[381]
    beam_clamped_free5_0_5_H_1_0 = p[382]
    beam_clamped_free5_0_5_H_1_1 = p[383]
    beam_clamped_free5_0_5_H_1_2 = p[384]
    beam_clamped_free5_0_5_H_1_3 = p[385]
    beam_clamped_free5_0_5_H_1_4 = p[386]
    beam_clamped_free5_0_5_H_2_0 = p[387]
    beam_clamped_free5_0_5_H_2_1 = p[388]
    beam_clamped_free5_0_5_H_2_2 = p[389]
    beam_clamped_free5_0_5_H_2_3 = p[390]
    beam_clamped_free5_0_5_H_2_4 = p[391]
    beam_clamped_free5_0_5_H_3_0 = p[392]
    beam_clamped_free5_0_5_H_3_1 = p[393]
    beam_clamped_free5_0_5_H_3_2 = p[394]
    beam_clamped_free5_0_5_H_3_3 = p[395]
    beam_clamped_free5_0_5_H_3_4 = p[396]
    beam_clamped_free5_0_5_H_4_0 = p[397]
    beam_clamped_free5_0_5_H_4_1 = p[398]
    beam_clamped_free5_0_5_H_4_2 = p[399]
    beam_clamped_free5_0_5_H_4_3 = p[400]
    beam_clamped_free5_0_5_H_4_4 = p[401]
    beam_clamped_free5_0_5625_at_0_0 = p[402]
    beam_clamped_free5_0_5625_shape_1_0 = p[403]
    beam_clamped_free5_0_5625_shape_1_1 = p[404]
    beam_clamped_free5_0_5625_shape_1_2 = p[405]
    beam_clamped_free5_0_5625_shape_1_3 = p[406]
    beam_clamped_free5_0_5625_shape_1_4 = p[407]
    beam_clamped_free5_0_5625_slope_0_0 = p[408]
    beam_clamped_free5_0_5625_slope_1_0 = p[409]
    beam_clamped_free5_0_5625_slope_2_0 = p[410]
    beam_clamped_free5_0_5625_slope_3_0 = p[411]
    beam_clamped_free5_0_5625_slope_4_0 = p[412]
    beam_clamped_free5_0_5625_H_0_0 = p[413]
    beam_clamped_free5_0_5625_H_0_1 = p[414]
    beam_clamped_free5_0_5625_H_0_2 = p[415]
    beam_clamped_free5_0_5625_H_0_3 = p[416]
    beam_clamped_free5_0_5625_H_0_4 = p[417]
    beam_clamped_free5_0_5625_H_1_0 = p[418]
    beam_clamped_free5_0_5625_H_1_1 = p[419]
    beam_clamped_free5_0_5625_H_1_2 = p[420]
    beam_clamped_free5_0_5625_H_1_3 = p[421]
    beam_clamped_free5_0_5625_H_1_4 = p[422]
    beam_clamped_free5_0_5625_H_2_0 = p[423]
    beam_clamped_free5_0_5625_H_2_1 = p[424]
    beam_clamped_free5_0_5625_H_2_2 = p[425]
    beam_clamped_free5_0_5625_H_2_3 = p[426]
    beam_clamped_free5_0_5625_H_2_4 = p[427]
    beam_clamped_free5_0_5625_H_3_0 = p[428]
    beam_clamped_free5_0_5625_H_3_1 = p[429]
    beam_clamped_free5_0_5625_H_3_2 = p[430]
    beam_clamped_free5_0_5625_H_3_3 = p[431]
    beam_clamped_free5_0_5625_H_3_4 = p[432]
    beam_clamped_free5_0_5625_H_4_0 = p[433]
    beam_clamped_free5_0_5625_H_4_1 = p[434]
    beam_clamped_free5_0_5625_H_4_2 = p[435]
    beam_clamped_free5_0_5625_H_4_3 = p[436]
    beam_clamped_free5_0_5625_H_4_4 = p[437]
    beam_clamped_free5_0_625_at_0_0 = p[438]
    beam_clamped_free5_0_625_shape_1_0 = p[439]
    beam_clamped_free5_0_625_shape_1_1 = p[440]
    beam_clamped_free5_0_625_shape_1_2 = p[441]
    beam_clamped_free5_0_625_shape_1_3 = p[442]
    beam_clamped_free5_0_625_shape_1_4 = p[443]
    beam_clamped_free5_0_625_slope_0_0 = p[444]
    beam_clamped_free5_0_625_slope_1_0 = p[445]
    beam_clamped_free5_0_625_slope_2_0 = p[446]
    beam_clamped_free5_0_625_slope_3_0 = p[447]
    beam_clamped_free5_0_625_slope_4_0 = p[448]
    beam_clamped_free5_0_625_H_0_0 = p[449]
    beam_clamped_free5_0_625_H_0_1 = p[450]
    beam_clamped_free5_0_625_H_0_2 = p[451]
    beam_clamped_free5_0_625_H_0_3 = p[452]
    beam_clamped_free5_0_625_H_0_4 = p[453]
    beam_clamped_free5_0_625_H_1_0 = p[454]
    beam_clamped_free5_0_625_H_1_1 = p[455]
    beam_clamped_free5_0_625_H_1_2 = p[456]
    beam_clamped_free5_0_625_H_1_3 = p[457]
    beam_clamped_free5_0_625_H_1_4 = p[458]
    beam_clamped_free5_0_625_H_2_0 = p[459]
    beam_clamped_free5_0_625_H_2_1 = p[460]
    beam_clamped_free5_0_625_H_2_2 = p[461]
    beam_clamped_free5_0_625_H_2_3 = p[462]
    beam_clamped_free5_0_625_H_2_4 = p[463]
    beam_clamped_free5_0_625_H_3_0 = p[464]
    beam_clamped_free5_0_625_H_3_1 = p[465]
    beam_clamped_free5_0_625_H_3_2 = p[466]
    beam_clamped_free5_0_625_H_3_3 = p[467]
    beam_clamped_free5_0_625_H_3_4 = p[468]
    beam_clamped_free5_0_625_H_4_0 = p[469]
    beam_clamped_free5_0_625_H_4_1 = p[470]
    beam_clamped_free5_0_625_H_4_2 = p[471]
    beam_clamped_free5_0_625_H_4_3 = p[472]
    beam_clamped_free5_0_625_H_4_4 = p[473]
    beam_clamped_free5_0_6875_at_0_0 = p[474]
    beam_clamped_free5_0_6875_shape_1_0 = p[475]
    beam_clamped_free5_0_6875_shape_1_1 = p[476]
    beam_clamped_free5_0_6875_shape_1_2 = p[477]
    beam_clamped_free5_0_6875_shape_1_3 = p[478]
    beam_clamped_free5_0_6875_shape_1_4 = p[479]
    beam_clamped_free5_0_6875_slope_0_0 = p[480]
    beam_clamped_free5_0_6875_slope_1_0 = p[481]
    beam_clamped_free5_0_6875_slope_2_0 = p[482]
    beam_clamped_free5_0_6875_slope_3_0 = p[483]
    beam_clamped_free5_0_6875_slope_4_0 = p[484]
    beam_clamped_free5_0_6875_H_0_0 = p[485]
    beam_clamped_free5_0_6875_H_0_1 = p[486]
    beam_clamped_free5_0_6875_H_0_2 = p[487]
    beam_clamped_free5_0_6875_H_0_3 = p[488]
    beam_clamped_free5_0_6875_H_0_4 = p[489]
    beam_clamped_free5_0_6875_H_1_0 = p[490]
    beam_clamped_free5_0_6875_H_1_1 = p[491]
    beam_clamped_free5_0_6875_H_1_2 = p[492]
    beam_clamped_free5_0_6875_H_1_3 = p[493]
    beam_clamped_free5_0_6875_H_1_4 = p[494]
    beam_clamped_free5_0_6875_H_2_0 = p[495]
    beam_clamped_free5_0_6875_H_2_1 = p[496]
    beam_clamped_free5_0_6875_H_2_2 = p[497]
    beam_clamped_free5_0_6875_H_2_3 = p[498]
    beam_clamped_free5_0_6875_H_2_4 = p[499]
    beam_clamped_free5_0_6875_H_3_0 = p[500]
    beam_clamped_free5_0_6875_H_3_1 = p[501]
    beam_clamped_free5_0_6875_H_3_2 = p[502]
    beam_clamped_free5_0_6875_H_3_3 = p[503]
    beam_clamped_free5_0_6875_H_3_4 = p[504]
    beam_clamped_free5_0_6875_H_4_0 = p[505]
    beam_clamped_free5_0_6875_H_4_1 = p[506]
    beam_clamped_free5_0_6875_H_4_2 = p[507]
    beam_clamped_free5_0_6875_H_4_3 = p[508]
    beam_clamped_free5_0_6875_H_4_4 = p[509]
    beam_clamped_free5_0_75_at_0_0 = p[510]
    beam_clamped_free5_0_75_shape_1_0 = p[511]
    beam_clamped_free5_0_75_shape_1_1 = p[512]
    beam_clamped_free5_0_75_shape_1_2 = p[513]
    beam_clamped_free5_0_75_shape_1_3 = p[514]
    beam_clamped_free5_0_75_shape_1_4 = p[515]
    beam_clamped_free5_0_75_slope_0_0 = p[516]
    beam_clamped_free5_0_75_slope_1_0 = p[517]
    beam_clamped_free5_0_75_slope_2_0 = p[518]
    beam_clamped_free5_0_75_slope_3_0 = p[519]
    beam_clamped_free5_0_75_slope_4_0 = p[520]
    beam_clamped_free5_0_75_H_0_0 = p[521]
    beam_clamped_free5_0_75_H_0_1 = p[522]
    beam_clamped_free5_0_75_H_0_2 = p[523]
    beam_clamped_free5_0_75_H_0_3 = p[524]
    beam_clamped_free5_0_75_H_0_4 = p[525]
    beam_clamped_free5_0_75_H_1_0 = p[526]
    beam_clamped_free5_0_75_H_1_1 = p[527]
    beam_clamped_free5_0_75_H_1_2 = p[528]
    beam_clamped_free5_0_75_H_1_3 = p[529]
    beam_clamped_free5_0_75_H_1_4 = p[530]
    beam_clamped_free5_0_75_H_2_0 = p[531]
    beam_clamped_free5_0_75_H_2_1 = p[532]
    beam_clamped_free5_0_75_H_2_2 = p[533]
    beam_clamped_free5_0_75_H_2_3 = p[534]
    beam_clamped_free5_0_75_H_2_4 = p[535]
    beam_clamped_free5_0_75_H_3_0 = p[536]
    beam_clamped_free5_0_75_H_3_1 = p[537]
    beam_clamped_free5_0_75_H_3_2 = p[538]
    beam_clamped_free5_0_75_H_3_3 = p[539]
    beam_clamped_free5_0_75_H_3_4 = p[540]
    beam_clamped_free5_0_75_H_4_0 = p[541]
    beam_clamped_free5_0_75_H_4_1 = p[542]
    beam_clamped_free5_0_75_H_4_2 = p[543]
    beam_clamped_free5_0_75_H_4_3 = p[544]
    beam_clamped_free5_0_75_H_4_4 = p[545]
    beam_clamped_free5_0_8125_at_0_0 = p[546]
    beam_clamped_free5_0_8125_shape_1_0 = p[547]
    beam_clamped_free5_0_8125_shape_1_1 = p[548]
    beam_clamped_free5_0_8125_shape_1_2 = p[549]
    beam_clamped_free5_0_8125_shape_1_3 = p[550]
    beam_clamped_free5_0_8125_shape_1_4 = p[551]
    beam_clamped_free5_0_8125_slope_0_0 = p[552]
    beam_clamped_free5_0_8125_slope_1_0 = p[553]
    beam_clamped_free5_0_8125_slope_2_0 = p[554]
    beam_clamped_free5_0_8125_slope_3_0 = p[555]
    beam_clamped_free5_0_8125_slope_4_0 = p[556]
    beam_clamped_free5_0_8125_H_0_0 = p[557]
    beam_clamped_free5_0_8125_H_0_1 = p[558]
    beam_clamped_free5_0_8125_H_0_2 = p[559]
    beam_clamped_free5_0_8125_H_0_3 = p[560]
    beam_clamped_free5_0_8125_H_0_4 = p[561]
    beam_clamped_free5_0_8125_H_1_0 = p[562]
    beam_clamped_free5_0_8125_H_1_1 = p[563]
    beam_clamped_free5_0_8125_H_1_2 = p[564]
    beam_clamped_free5_0_8125_H_1_3 = p[565]
    beam_clamped_free5_0_8125_H_1_4 = p[566]
    beam_clamped_free5_0_8125_H_2_0 = p[567]
    beam_clamped_free5_0_8125_H_2_1 = p[568]
    beam_clamped_free5_0_8125_H_2_2 = p[569]
    beam_clamped_free5_0_8125_H_2_3 = p[570]
    beam_clamped_free5_0_8125_H_2_4 = p[571]
    beam_clamped_free5_0_8125_H_3_0 = p[572]
    beam_clamped_free5_0_8125_H_3_1 = p[573]
    beam_clamped_free5_0_8125_H_3_2 = p[574]
    beam_clamped_free5_0_8125_H_3_3 = p[575]
    beam_clamped_free5_0_8125_H_3_4 = p[576]
    beam_clamped_free5_0_8125_H_4_0 = p[577]
    beam_clamped_free5_0_8125_H_4_1 = p[578]
    beam_clamped_free5_0_8125_H_4_2 = p[579]
    beam_clamped_free5_0_8125_H_4_3 = p[580]
    beam_clamped_free5_0_8125_H_4_4 = p[581]
    beam_clamped_free5_0_875_at_0_0 = p[582]
    beam_clamped_free5_0_875_shape_1_0 = p[583]
    beam_clamped_free5_0_875_shape_1_1 = p[584]
    beam_clamped_free5_0_875_shape_1_2 = p[585]
    beam_clamped_free5_0_875_shape_1_3 = p[586]
    beam_clamped_free5_0_875_shape_1_4 = p[587]
    beam_clamped_free5_0_875_slope_0_0 = p[588]
    beam_clamped_free5_0_875_slope_1_0 = p[589]
    beam_clamped_free5_0_875_slope_2_0 = p[590]
    beam_clamped_free5_0_875_slope_3_0 = p[591]
    beam_clamped_free5_0_875_slope_4_0 = p[592]
    beam_clamped_free5_0_875_H_0_0 = p[593]
    beam_clamped_free5_0_875_H_0_1 = p[594]
    beam_clamped_free5_0_875_H_0_2 = p[595]
    beam_clamped_free5_0_875_H_0_3 = p[596]
    beam_clamped_free5_0_875_H_0_4 = p[597]
    beam_clamped_free5_0_875_H_1_0 = p[598]
    beam_clamped_free5_0_875_H_1_1 = p[599]
    beam_clamped_free5_0_875_H_1_2 = p[600]
    beam_clamped_free5_0_875_H_1_3 = p[601]
    beam_clamped_free5_0_875_H_1_4 = p[602]
    beam_clamped_free5_0_875_H_2_0 = p[603]
    beam_clamped_free5_0_875_H_2_1 = p[604]
    beam_clamped_free5_0_875_H_2_2 = p[605]
    beam_clamped_free5_0_875_H_2_3 = p[606]
    beam_clamped_free5_0_875_H_2_4 = p[607]
    beam_clamped_free5_0_875_H_3_0 = p[608]
    beam_clamped_free5_0_875_H_3_1 = p[609]
    beam_clamped_free5_0_875_H_3_2 = p[610]
    beam_clamped_free5_0_875_H_3_3 = p[611]
    beam_clamped_free5_0_875_H_3_4 = p[612]
    beam_clamped_free5_0_875_H_4_0 = p[613]
    beam_clamped_free5_0_875_H_4_1 = p[614]
    beam_clamped_free5_0_875_H_4_2 = p[615]
    beam_clamped_free5_0_875_H_4_3 = p[616]
    beam_clamped_free5_0_875_H_4_4 = p[617]
    beam_clamped_free5_0_9375_at_0_0 = p[618]
    beam_clamped_free5_0_9375_shape_1_0 = p[619]
    beam_clamped_free5_0_9375_shape_1_1 = p[620]
    beam_clamped_free5_0_9375_shape_1_2 = p[621]
    beam_clamped_free5_0_9375_shape_1_3 = p[622]
    beam_clamped_free5_0_9375_shape_1_4 = p[623]
    beam_clamped_free5_0_9375_slope_0_0 = p[624]
    beam_clamped_free5_0_9375_slope_1_0 = p[625]
    beam_clamped_free5_0_9375_slope_2_0 = p[626]
    beam_clamped_free5_0_9375_slope_3_0 = p[627]
    beam_clamped_free5_0_9375_slope_4_0 = p[628]
    beam_clamped_free5_0_9375_H_0_0 = p[629]
    beam_clamped_free5_0_9375_H_0_1 = p[630]
    beam_clamped_free5_0_9375_H_0_2 = p[631]
    beam_clamped_free5_0_9375_H_0_3 = p[632]
    beam_clamped_free5_0_9375_H_0_4 = p[633]
    beam_clamped_free5_0_9375_H_1_0 = p[634]
    beam_clamped_free5_0_9375_H_1_1 = p[635]
    beam_clamped_free5_0_9375_H_1_2 = p[636]
    beam_clamped_free5_0_9375_H_1_3 = p[637]
    beam_clamped_free5_0_9375_H_1_4 = p[638]
    beam_clamped_free5_0_9375_H_2_0 = p[639]
    beam_clamped_free5_0_9375_H_2_1 = p[640]
    beam_clamped_free5_0_9375_H_2_2 = p[641]
    beam_clamped_free5_0_9375_H_2_3 = p[642]
    beam_clamped_free5_0_9375_H_2_4 = p[643]
    beam_clamped_free5_0_9375_H_3_0 = p[644]
    beam_clamped_free5_0_9375_H_3_1 = p[645]
    beam_clamped_free5_0_9375_H_3_2 = p[646]
    beam_clamped_free5_0_9375_H_3_3 = p[647]
    beam_clamped_free5_0_9375_H_3_4 = p[648]
    beam_clamped_free5_0_9375_H_4_0 = p[649]
    beam_clamped_free5_0_9375_H_4_1 = p[650]
    beam_clamped_free5_0_9375_H_4_2 = p[651]
    beam_clamped_free5_0_9375_H_4_3 = p[652]
    beam_clamped_free5_0_9375_H_4_4 = p[653]
    # intermediate terms (31)
    w0 = beam_clamped_free5_1_0_slope_0_0 / beam_length
    w1 = beam_clamped_free5_1_0_slope_1_0 / beam_length
    w2 = beam_clamped_free5_1_0_slope_2_0 / beam_length
    w3 = beam_clamped_free5_1_0_slope_3_0 / beam_length
    w4 = beam_clamped_free5_1_0_slope_4_0 / beam_length
    w5 = beam_clamped_free5_1_0_H_0_0 / beam_length
    w6 = beam_clamped_free5_1_0_H_0_1 / beam_length
    w7 = beam_clamped_free5_1_0_H_0_2 / beam_length
    w8 = beam_clamped_free5_1_0_H_0_3 / beam_length
    w9 = beam_clamped_free5_1_0_H_0_4 / beam_length
    w10 = beam_clamped_free5_1_0_H_1_0 / beam_length
    w11 = beam_clamped_free5_1_0_H_1_1 / beam_length
    w12 = beam_clamped_free5_1_0_H_1_2 / beam_length
    w13 = beam_clamped_free5_1_0_H_1_3 / beam_length
    w14 = beam_clamped_free5_1_0_H_1_4 / beam_length
    w15 = beam_clamped_free5_1_0_H_2_0 / beam_length
    w16 = beam_clamped_free5_1_0_H_2_1 / beam_length
    w17 = beam_clamped_free5_1_0_H_2_2 / beam_length
    w18 = beam_clamped_free5_1_0_H_2_3 / beam_length
    w19 = beam_clamped_free5_1_0_H_2_4 / beam_length
    w20 = beam_clamped_free5_1_0_H_3_0 / beam_length
    w21 = beam_clamped_free5_1_0_H_3_1 / beam_length
    w22 = beam_clamped_free5_1_0_H_3_2 / beam_length
    w23 = beam_clamped_free5_1_0_H_3_3 / beam_length
    w24 = beam_clamped_free5_1_0_H_3_4 / beam_length
    w25 = beam_clamped_free5_1_0_H_4_0 / beam_length
    w26 = beam_clamped_free5_1_0_H_4_1 / beam_length
    w27 = beam_clamped_free5_1_0_H_4_2 / beam_length
    w28 = beam_clamped_free5_1_0_H_4_3 / beam_length
    w29 = beam_clamped_free5_1_0_H_4_4 / beam_length
    w30 = ca.sqrt(12.0 * beam_second_moment / beam_area)
    # outputs
    positions = ca.SX(3, 20)
    positions[0, 1] = beam_length * beam_clamped_free5_0_0625_at_0_0
    positions[0, 2] = beam_length * beam_clamped_free5_0_125_at_0_0
    positions[0, 3] = beam_length * beam_clamped_free5_0_1875_at_0_0
    positions[0, 4] = beam_length * beam_clamped_free5_0_25_at_0_0
    positions[0, 5] = beam_length * beam_clamped_free5_0_3125_at_0_0
    positions[0, 6] = beam_length * beam_clamped_free5_0_375_at_0_0
    positions[0, 7] = beam_length * beam_clamped_free5_0_4375_at_0_0
    positions[0, 8] = beam_length * beam_clamped_free5_0_5_at_0_0
    positions[0, 9] = beam_length * beam_clamped_free5_0_5625_at_0_0
    positions[0, 10] = beam_length * beam_clamped_free5_0_625_at_0_0
    positions[0, 11] = beam_length * beam_clamped_free5_0_6875_at_0_0
    positions[0, 12] = beam_length * beam_clamped_free5_0_75_at_0_0
    positions[0, 13] = beam_length * beam_clamped_free5_0_8125_at_0_0
    positions[0, 14] = beam_length * beam_clamped_free5_0_875_at_0_0
    positions[0, 15] = beam_length * beam_clamped_free5_0_9375_at_0_0
    positions[0, 16] = beam_length
    positions[0, 19] = beam_length
    axes = ca.SX(9, 20)
    axes[0, 0] = 1.0
    axes[0, 1] = 1.0
    axes[0, 2] = 1.0
    axes[0, 3] = 1.0
    axes[0, 4] = 1.0
    axes[0, 5] = 1.0
    axes[0, 6] = 1.0
    axes[0, 7] = 1.0
    axes[0, 8] = 1.0
    axes[0, 9] = 1.0
    axes[0, 10] = 1.0
    axes[0, 11] = 1.0
    axes[0, 12] = 1.0
    axes[0, 13] = 1.0
    axes[0, 14] = 1.0
    axes[0, 15] = 1.0
    axes[0, 16] = 1.0
    axes[0, 17] = 1.0
    axes[0, 18] = 1.0
    axes[0, 19] = 1.0
    axes[4, 0] = 1.0
    axes[4, 1] = 1.0
    axes[4, 2] = 1.0
    axes[4, 3] = 1.0
    axes[4, 4] = 1.0
    axes[4, 5] = 1.0
    axes[4, 6] = 1.0
    axes[4, 7] = 1.0
    axes[4, 8] = 1.0
    axes[4, 9] = 1.0
    axes[4, 10] = 1.0
    axes[4, 11] = 1.0
    axes[4, 12] = 1.0
    axes[4, 13] = 1.0
    axes[4, 14] = 1.0
    axes[4, 15] = 1.0
    axes[4, 16] = 1.0
    axes[4, 17] = 1.0
    axes[4, 18] = 1.0
    axes[4, 19] = 1.0
    axes[8, 0] = 1.0
    axes[8, 1] = 1.0
    axes[8, 2] = 1.0
    axes[8, 3] = 1.0
    axes[8, 4] = 1.0
    axes[8, 5] = 1.0
    axes[8, 6] = 1.0
    axes[8, 7] = 1.0
    axes[8, 8] = 1.0
    axes[8, 9] = 1.0
    axes[8, 10] = 1.0
    axes[8, 11] = 1.0
    axes[8, 12] = 1.0
    axes[8, 13] = 1.0
    axes[8, 14] = 1.0
    axes[8, 15] = 1.0
    axes[8, 16] = 1.0
    axes[8, 17] = 1.0
    axes[8, 18] = 1.0
    axes[8, 19] = 1.0
    shapes = ca.SX(3, 95)
    shapes[1, 5] = beam_clamped_free5_0_0625_shape_1_0
    shapes[1, 6] = beam_clamped_free5_0_0625_shape_1_1
    shapes[1, 7] = beam_clamped_free5_0_0625_shape_1_2
    shapes[1, 8] = beam_clamped_free5_0_0625_shape_1_3
    shapes[1, 9] = beam_clamped_free5_0_0625_shape_1_4
    shapes[1, 10] = beam_clamped_free5_0_125_shape_1_0
    shapes[1, 11] = beam_clamped_free5_0_125_shape_1_1
    shapes[1, 12] = beam_clamped_free5_0_125_shape_1_2
    shapes[1, 13] = beam_clamped_free5_0_125_shape_1_3
    shapes[1, 14] = beam_clamped_free5_0_125_shape_1_4
    shapes[1, 15] = beam_clamped_free5_0_1875_shape_1_0
    shapes[1, 16] = beam_clamped_free5_0_1875_shape_1_1
    shapes[1, 17] = beam_clamped_free5_0_1875_shape_1_2
    shapes[1, 18] = beam_clamped_free5_0_1875_shape_1_3
    shapes[1, 19] = beam_clamped_free5_0_1875_shape_1_4
    shapes[1, 20] = beam_clamped_free5_0_25_shape_1_0
    shapes[1, 21] = beam_clamped_free5_0_25_shape_1_1
    shapes[1, 22] = beam_clamped_free5_0_25_shape_1_2
    shapes[1, 23] = beam_clamped_free5_0_25_shape_1_3
    shapes[1, 24] = beam_clamped_free5_0_25_shape_1_4
    shapes[1, 25] = beam_clamped_free5_0_3125_shape_1_0
    shapes[1, 26] = beam_clamped_free5_0_3125_shape_1_1
    shapes[1, 27] = beam_clamped_free5_0_3125_shape_1_2
    shapes[1, 28] = beam_clamped_free5_0_3125_shape_1_3
    shapes[1, 29] = beam_clamped_free5_0_3125_shape_1_4
    shapes[1, 30] = beam_clamped_free5_0_375_shape_1_0
    shapes[1, 31] = beam_clamped_free5_0_375_shape_1_1
    shapes[1, 32] = beam_clamped_free5_0_375_shape_1_2
    shapes[1, 33] = beam_clamped_free5_0_375_shape_1_3
    shapes[1, 34] = beam_clamped_free5_0_375_shape_1_4
    shapes[1, 35] = beam_clamped_free5_0_4375_shape_1_0
    shapes[1, 36] = beam_clamped_free5_0_4375_shape_1_1
    shapes[1, 37] = beam_clamped_free5_0_4375_shape_1_2
    shapes[1, 38] = beam_clamped_free5_0_4375_shape_1_3
    shapes[1, 39] = beam_clamped_free5_0_4375_shape_1_4
    shapes[1, 40] = beam_clamped_free5_0_5_shape_1_0
    shapes[1, 41] = beam_clamped_free5_0_5_shape_1_1
    shapes[1, 42] = beam_clamped_free5_0_5_shape_1_2
    shapes[1, 43] = beam_clamped_free5_0_5_shape_1_3
    shapes[1, 44] = beam_clamped_free5_0_5_shape_1_4
    shapes[1, 45] = beam_clamped_free5_0_5625_shape_1_0
    shapes[1, 46] = beam_clamped_free5_0_5625_shape_1_1
    shapes[1, 47] = beam_clamped_free5_0_5625_shape_1_2
    shapes[1, 48] = beam_clamped_free5_0_5625_shape_1_3
    shapes[1, 49] = beam_clamped_free5_0_5625_shape_1_4
    shapes[1, 50] = beam_clamped_free5_0_625_shape_1_0
    shapes[1, 51] = beam_clamped_free5_0_625_shape_1_1
    shapes[1, 52] = beam_clamped_free5_0_625_shape_1_2
    shapes[1, 53] = beam_clamped_free5_0_625_shape_1_3
    shapes[1, 54] = beam_clamped_free5_0_625_shape_1_4
    shapes[1, 55] = beam_clamped_free5_0_6875_shape_1_0
    shapes[1, 56] = beam_clamped_free5_0_6875_shape_1_1
    shapes[1, 57] = beam_clamped_free5_0_6875_shape_1_2
    shapes[1, 58] = beam_clamped_free5_0_6875_shape_1_3
    shapes[1, 59] = beam_clamped_free5_0_6875_shape_1_4
    shapes[1, 60] = beam_clamped_free5_0_75_shape_1_0
    shapes[1, 61] = beam_clamped_free5_0_75_shape_1_1
    shapes[1, 62] = beam_clamped_free5_0_75_shape_1_2
    shapes[1, 63] = beam_clamped_free5_0_75_shape_1_3
    shapes[1, 64] = beam_clamped_free5_0_75_shape_1_4
    shapes[1, 65] = beam_clamped_free5_0_8125_shape_1_0
    shapes[1, 66] = beam_clamped_free5_0_8125_shape_1_1
    shapes[1, 67] = beam_clamped_free5_0_8125_shape_1_2
    shapes[1, 68] = beam_clamped_free5_0_8125_shape_1_3
    shapes[1, 69] = beam_clamped_free5_0_8125_shape_1_4
    shapes[1, 70] = beam_clamped_free5_0_875_shape_1_0
    shapes[1, 71] = beam_clamped_free5_0_875_shape_1_1
    shapes[1, 72] = beam_clamped_free5_0_875_shape_1_2
    shapes[1, 73] = beam_clamped_free5_0_875_shape_1_3
    shapes[1, 74] = beam_clamped_free5_0_875_shape_1_4
    shapes[1, 75] = beam_clamped_free5_0_9375_shape_1_0
    shapes[1, 76] = beam_clamped_free5_0_9375_shape_1_1
    shapes[1, 77] = beam_clamped_free5_0_9375_shape_1_2
    shapes[1, 78] = beam_clamped_free5_0_9375_shape_1_3
    shapes[1, 79] = beam_clamped_free5_0_9375_shape_1_4
    shapes[1, 80] = beam_clamped_free5_1_0_shape_1_0
    shapes[1, 81] = beam_clamped_free5_1_0_shape_1_1
    shapes[1, 82] = beam_clamped_free5_1_0_shape_1_2
    shapes[1, 83] = beam_clamped_free5_1_0_shape_1_3
    shapes[1, 84] = beam_clamped_free5_1_0_shape_1_4
    shapes[1, 90] = beam_clamped_free5_1_0_shape_1_0
    shapes[1, 91] = beam_clamped_free5_1_0_shape_1_1
    shapes[1, 92] = beam_clamped_free5_1_0_shape_1_2
    shapes[1, 93] = beam_clamped_free5_1_0_shape_1_3
    shapes[1, 94] = beam_clamped_free5_1_0_shape_1_4
    turns = ca.SX(3, 95)
    turns[2, 5] = beam_clamped_free5_0_0625_slope_0_0 / beam_length
    turns[2, 6] = beam_clamped_free5_0_0625_slope_1_0 / beam_length
    turns[2, 7] = beam_clamped_free5_0_0625_slope_2_0 / beam_length
    turns[2, 8] = beam_clamped_free5_0_0625_slope_3_0 / beam_length
    turns[2, 9] = beam_clamped_free5_0_0625_slope_4_0 / beam_length
    turns[2, 10] = beam_clamped_free5_0_125_slope_0_0 / beam_length
    turns[2, 11] = beam_clamped_free5_0_125_slope_1_0 / beam_length
    turns[2, 12] = beam_clamped_free5_0_125_slope_2_0 / beam_length
    turns[2, 13] = beam_clamped_free5_0_125_slope_3_0 / beam_length
    turns[2, 14] = beam_clamped_free5_0_125_slope_4_0 / beam_length
    turns[2, 15] = beam_clamped_free5_0_1875_slope_0_0 / beam_length
    turns[2, 16] = beam_clamped_free5_0_1875_slope_1_0 / beam_length
    turns[2, 17] = beam_clamped_free5_0_1875_slope_2_0 / beam_length
    turns[2, 18] = beam_clamped_free5_0_1875_slope_3_0 / beam_length
    turns[2, 19] = beam_clamped_free5_0_1875_slope_4_0 / beam_length
    turns[2, 20] = beam_clamped_free5_0_25_slope_0_0 / beam_length
    turns[2, 21] = beam_clamped_free5_0_25_slope_1_0 / beam_length
    turns[2, 22] = beam_clamped_free5_0_25_slope_2_0 / beam_length
    turns[2, 23] = beam_clamped_free5_0_25_slope_3_0 / beam_length
    turns[2, 24] = beam_clamped_free5_0_25_slope_4_0 / beam_length
    turns[2, 25] = beam_clamped_free5_0_3125_slope_0_0 / beam_length
    turns[2, 26] = beam_clamped_free5_0_3125_slope_1_0 / beam_length
    turns[2, 27] = beam_clamped_free5_0_3125_slope_2_0 / beam_length
    turns[2, 28] = beam_clamped_free5_0_3125_slope_3_0 / beam_length
    turns[2, 29] = beam_clamped_free5_0_3125_slope_4_0 / beam_length
    turns[2, 30] = beam_clamped_free5_0_375_slope_0_0 / beam_length
    turns[2, 31] = beam_clamped_free5_0_375_slope_1_0 / beam_length
    turns[2, 32] = beam_clamped_free5_0_375_slope_2_0 / beam_length
    turns[2, 33] = beam_clamped_free5_0_375_slope_3_0 / beam_length
    turns[2, 34] = beam_clamped_free5_0_375_slope_4_0 / beam_length
    turns[2, 35] = beam_clamped_free5_0_4375_slope_0_0 / beam_length
    turns[2, 36] = beam_clamped_free5_0_4375_slope_1_0 / beam_length
    turns[2, 37] = beam_clamped_free5_0_4375_slope_2_0 / beam_length
    turns[2, 38] = beam_clamped_free5_0_4375_slope_3_0 / beam_length
    turns[2, 39] = beam_clamped_free5_0_4375_slope_4_0 / beam_length
    turns[2, 40] = beam_clamped_free5_0_5_slope_0_0 / beam_length
    turns[2, 41] = beam_clamped_free5_0_5_slope_1_0 / beam_length
    turns[2, 42] = beam_clamped_free5_0_5_slope_2_0 / beam_length
    turns[2, 43] = beam_clamped_free5_0_5_slope_3_0 / beam_length
    turns[2, 44] = beam_clamped_free5_0_5_slope_4_0 / beam_length
    turns[2, 45] = beam_clamped_free5_0_5625_slope_0_0 / beam_length
    turns[2, 46] = beam_clamped_free5_0_5625_slope_1_0 / beam_length
    turns[2, 47] = beam_clamped_free5_0_5625_slope_2_0 / beam_length
    turns[2, 48] = beam_clamped_free5_0_5625_slope_3_0 / beam_length
    turns[2, 49] = beam_clamped_free5_0_5625_slope_4_0 / beam_length
    turns[2, 50] = beam_clamped_free5_0_625_slope_0_0 / beam_length
    turns[2, 51] = beam_clamped_free5_0_625_slope_1_0 / beam_length
    turns[2, 52] = beam_clamped_free5_0_625_slope_2_0 / beam_length
    turns[2, 53] = beam_clamped_free5_0_625_slope_3_0 / beam_length
    turns[2, 54] = beam_clamped_free5_0_625_slope_4_0 / beam_length
    turns[2, 55] = beam_clamped_free5_0_6875_slope_0_0 / beam_length
    turns[2, 56] = beam_clamped_free5_0_6875_slope_1_0 / beam_length
    turns[2, 57] = beam_clamped_free5_0_6875_slope_2_0 / beam_length
    turns[2, 58] = beam_clamped_free5_0_6875_slope_3_0 / beam_length
    turns[2, 59] = beam_clamped_free5_0_6875_slope_4_0 / beam_length
    turns[2, 60] = beam_clamped_free5_0_75_slope_0_0 / beam_length
    turns[2, 61] = beam_clamped_free5_0_75_slope_1_0 / beam_length
    turns[2, 62] = beam_clamped_free5_0_75_slope_2_0 / beam_length
    turns[2, 63] = beam_clamped_free5_0_75_slope_3_0 / beam_length
    turns[2, 64] = beam_clamped_free5_0_75_slope_4_0 / beam_length
    turns[2, 65] = beam_clamped_free5_0_8125_slope_0_0 / beam_length
    turns[2, 66] = beam_clamped_free5_0_8125_slope_1_0 / beam_length
    turns[2, 67] = beam_clamped_free5_0_8125_slope_2_0 / beam_length
    turns[2, 68] = beam_clamped_free5_0_8125_slope_3_0 / beam_length
    turns[2, 69] = beam_clamped_free5_0_8125_slope_4_0 / beam_length
    turns[2, 70] = beam_clamped_free5_0_875_slope_0_0 / beam_length
    turns[2, 71] = beam_clamped_free5_0_875_slope_1_0 / beam_length
    turns[2, 72] = beam_clamped_free5_0_875_slope_2_0 / beam_length
    turns[2, 73] = beam_clamped_free5_0_875_slope_3_0 / beam_length
    turns[2, 74] = beam_clamped_free5_0_875_slope_4_0 / beam_length
    turns[2, 75] = beam_clamped_free5_0_9375_slope_0_0 / beam_length
    turns[2, 76] = beam_clamped_free5_0_9375_slope_1_0 / beam_length
    turns[2, 77] = beam_clamped_free5_0_9375_slope_2_0 / beam_length
    turns[2, 78] = beam_clamped_free5_0_9375_slope_3_0 / beam_length
    turns[2, 79] = beam_clamped_free5_0_9375_slope_4_0 / beam_length
    turns[2, 80] = w0
    turns[2, 81] = w1
    turns[2, 82] = w2
    turns[2, 83] = w3
    turns[2, 84] = w4
    turns[2, 90] = w0
    turns[2, 91] = w1
    turns[2, 92] = w2
    turns[2, 93] = w3
    turns[2, 94] = w4
    H = ca.horzcat(
        beam_clamped_free5_0_0625_H_0_0 / beam_length, beam_clamped_free5_0_0625_H_0_1 / beam_length,
        beam_clamped_free5_0_0625_H_0_2 / beam_length, beam_clamped_free5_0_0625_H_0_3 / beam_length,
        beam_clamped_free5_0_0625_H_0_4 / beam_length, beam_clamped_free5_0_0625_H_1_0 / beam_length,
        beam_clamped_free5_0_0625_H_1_1 / beam_length, beam_clamped_free5_0_0625_H_1_2 / beam_length,
        beam_clamped_free5_0_0625_H_1_3 / beam_length, beam_clamped_free5_0_0625_H_1_4 / beam_length,
        beam_clamped_free5_0_0625_H_2_0 / beam_length, beam_clamped_free5_0_0625_H_2_1 / beam_length,
        beam_clamped_free5_0_0625_H_2_2 / beam_length, beam_clamped_free5_0_0625_H_2_3 / beam_length,
        beam_clamped_free5_0_0625_H_2_4 / beam_length, beam_clamped_free5_0_0625_H_3_0 / beam_length,
        beam_clamped_free5_0_0625_H_3_1 / beam_length, beam_clamped_free5_0_0625_H_3_2 / beam_length,
        beam_clamped_free5_0_0625_H_3_3 / beam_length, beam_clamped_free5_0_0625_H_3_4 / beam_length,
        beam_clamped_free5_0_0625_H_4_0 / beam_length, beam_clamped_free5_0_0625_H_4_1 / beam_length,
        beam_clamped_free5_0_0625_H_4_2 / beam_length, beam_clamped_free5_0_0625_H_4_3 / beam_length,
        beam_clamped_free5_0_0625_H_4_4 / beam_length, beam_clamped_free5_0_125_H_0_0 / beam_length,
        beam_clamped_free5_0_125_H_0_1 / beam_length, beam_clamped_free5_0_125_H_0_2 / beam_length,
        beam_clamped_free5_0_125_H_0_3 / beam_length, beam_clamped_free5_0_125_H_0_4 / beam_length,
        beam_clamped_free5_0_125_H_1_0 / beam_length, beam_clamped_free5_0_125_H_1_1 / beam_length,
        beam_clamped_free5_0_125_H_1_2 / beam_length, beam_clamped_free5_0_125_H_1_3 / beam_length,
        beam_clamped_free5_0_125_H_1_4 / beam_length, beam_clamped_free5_0_125_H_2_0 / beam_length,
        beam_clamped_free5_0_125_H_2_1 / beam_length, beam_clamped_free5_0_125_H_2_2 / beam_length,
        beam_clamped_free5_0_125_H_2_3 / beam_length, beam_clamped_free5_0_125_H_2_4 / beam_length,
        beam_clamped_free5_0_125_H_3_0 / beam_length, beam_clamped_free5_0_125_H_3_1 / beam_length,
        beam_clamped_free5_0_125_H_3_2 / beam_length, beam_clamped_free5_0_125_H_3_3 / beam_length,
        beam_clamped_free5_0_125_H_3_4 / beam_length, beam_clamped_free5_0_125_H_4_0 / beam_length,
        beam_clamped_free5_0_125_H_4_1 / beam_length, beam_clamped_free5_0_125_H_4_2 / beam_length,
        beam_clamped_free5_0_125_H_4_3 / beam_length, beam_clamped_free5_0_125_H_4_4 / beam_length,
        beam_clamped_free5_0_1875_H_0_0 / beam_length, beam_clamped_free5_0_1875_H_0_1 / beam_length,
        beam_clamped_free5_0_1875_H_0_2 / beam_length, beam_clamped_free5_0_1875_H_0_3 / beam_length,
        beam_clamped_free5_0_1875_H_0_4 / beam_length, beam_clamped_free5_0_1875_H_1_0 / beam_length,
        beam_clamped_free5_0_1875_H_1_1 / beam_length, beam_clamped_free5_0_1875_H_1_2 / beam_length,
        beam_clamped_free5_0_1875_H_1_3 / beam_length, beam_clamped_free5_0_1875_H_1_4 / beam_length,
        beam_clamped_free5_0_1875_H_2_0 / beam_length, beam_clamped_free5_0_1875_H_2_1 / beam_length,
        beam_clamped_free5_0_1875_H_2_2 / beam_length, beam_clamped_free5_0_1875_H_2_3 / beam_length,
        beam_clamped_free5_0_1875_H_2_4 / beam_length, beam_clamped_free5_0_1875_H_3_0 / beam_length,
        beam_clamped_free5_0_1875_H_3_1 / beam_length, beam_clamped_free5_0_1875_H_3_2 / beam_length,
        beam_clamped_free5_0_1875_H_3_3 / beam_length, beam_clamped_free5_0_1875_H_3_4 / beam_length,
        beam_clamped_free5_0_1875_H_4_0 / beam_length, beam_clamped_free5_0_1875_H_4_1 / beam_length,
        beam_clamped_free5_0_1875_H_4_2 / beam_length, beam_clamped_free5_0_1875_H_4_3 / beam_length,
        beam_clamped_free5_0_1875_H_4_4 / beam_length, beam_clamped_free5_0_25_H_0_0 / beam_length,
        beam_clamped_free5_0_25_H_0_1 / beam_length, beam_clamped_free5_0_25_H_0_2 / beam_length,
        beam_clamped_free5_0_25_H_0_3 / beam_length, beam_clamped_free5_0_25_H_0_4 / beam_length,
        beam_clamped_free5_0_25_H_1_0 / beam_length, beam_clamped_free5_0_25_H_1_1 / beam_length,
        beam_clamped_free5_0_25_H_1_2 / beam_length, beam_clamped_free5_0_25_H_1_3 / beam_length,
        beam_clamped_free5_0_25_H_1_4 / beam_length, beam_clamped_free5_0_25_H_2_0 / beam_length,
        beam_clamped_free5_0_25_H_2_1 / beam_length, beam_clamped_free5_0_25_H_2_2 / beam_length,
        beam_clamped_free5_0_25_H_2_3 / beam_length, beam_clamped_free5_0_25_H_2_4 / beam_length,
        beam_clamped_free5_0_25_H_3_0 / beam_length, beam_clamped_free5_0_25_H_3_1 / beam_length,
        beam_clamped_free5_0_25_H_3_2 / beam_length, beam_clamped_free5_0_25_H_3_3 / beam_length,
        beam_clamped_free5_0_25_H_3_4 / beam_length, beam_clamped_free5_0_25_H_4_0 / beam_length,
        beam_clamped_free5_0_25_H_4_1 / beam_length, beam_clamped_free5_0_25_H_4_2 / beam_length,
        beam_clamped_free5_0_25_H_4_3 / beam_length, beam_clamped_free5_0_25_H_4_4 / beam_length,
        beam_clamped_free5_0_3125_H_0_0 / beam_length, beam_clamped_free5_0_3125_H_0_1 / beam_length,
        beam_clamped_free5_0_3125_H_0_2 / beam_length, beam_clamped_free5_0_3125_H_0_3 / beam_length,
        beam_clamped_free5_0_3125_H_0_4 / beam_length, beam_clamped_free5_0_3125_H_1_0 / beam_length,
        beam_clamped_free5_0_3125_H_1_1 / beam_length, beam_clamped_free5_0_3125_H_1_2 / beam_length,
        beam_clamped_free5_0_3125_H_1_3 / beam_length, beam_clamped_free5_0_3125_H_1_4 / beam_length,
        beam_clamped_free5_0_3125_H_2_0 / beam_length, beam_clamped_free5_0_3125_H_2_1 / beam_length,
        beam_clamped_free5_0_3125_H_2_2 / beam_length, beam_clamped_free5_0_3125_H_2_3 / beam_length,
        beam_clamped_free5_0_3125_H_2_4 / beam_length, beam_clamped_free5_0_3125_H_3_0 / beam_length,
        beam_clamped_free5_0_3125_H_3_1 / beam_length, beam_clamped_free5_0_3125_H_3_2 / beam_length,
        beam_clamped_free5_0_3125_H_3_3 / beam_length, beam_clamped_free5_0_3125_H_3_4 / beam_length,
        beam_clamped_free5_0_3125_H_4_0 / beam_length, beam_clamped_free5_0_3125_H_4_1 / beam_length,
        beam_clamped_free5_0_3125_H_4_2 / beam_length, beam_clamped_free5_0_3125_H_4_3 / beam_length,
        beam_clamped_free5_0_3125_H_4_4 / beam_length, beam_clamped_free5_0_375_H_0_0 / beam_length,
        beam_clamped_free5_0_375_H_0_1 / beam_length, beam_clamped_free5_0_375_H_0_2 / beam_length,
        beam_clamped_free5_0_375_H_0_3 / beam_length, beam_clamped_free5_0_375_H_0_4 / beam_length,
        beam_clamped_free5_0_375_H_1_0 / beam_length, beam_clamped_free5_0_375_H_1_1 / beam_length,
        beam_clamped_free5_0_375_H_1_2 / beam_length, beam_clamped_free5_0_375_H_1_3 / beam_length,
        beam_clamped_free5_0_375_H_1_4 / beam_length, beam_clamped_free5_0_375_H_2_0 / beam_length,
        beam_clamped_free5_0_375_H_2_1 / beam_length, beam_clamped_free5_0_375_H_2_2 / beam_length,
        beam_clamped_free5_0_375_H_2_3 / beam_length, beam_clamped_free5_0_375_H_2_4 / beam_length,
        beam_clamped_free5_0_375_H_3_0 / beam_length, beam_clamped_free5_0_375_H_3_1 / beam_length,
        beam_clamped_free5_0_375_H_3_2 / beam_length, beam_clamped_free5_0_375_H_3_3 / beam_length,
        beam_clamped_free5_0_375_H_3_4 / beam_length, beam_clamped_free5_0_375_H_4_0 / beam_length,
        beam_clamped_free5_0_375_H_4_1 / beam_length, beam_clamped_free5_0_375_H_4_2 / beam_length,
        beam_clamped_free5_0_375_H_4_3 / beam_length, beam_clamped_free5_0_375_H_4_4 / beam_length,
        beam_clamped_free5_0_4375_H_0_0 / beam_length, beam_clamped_free5_0_4375_H_0_1 / beam_length,
        beam_clamped_free5_0_4375_H_0_2 / beam_length, beam_clamped_free5_0_4375_H_0_3 / beam_length,
        beam_clamped_free5_0_4375_H_0_4 / beam_length, beam_clamped_free5_0_4375_H_1_0 / beam_length,
        beam_clamped_free5_0_4375_H_1_1 / beam_length, beam_clamped_free5_0_4375_H_1_2 / beam_length,
        beam_clamped_free5_0_4375_H_1_3 / beam_length, beam_clamped_free5_0_4375_H_1_4 / beam_length,
        beam_clamped_free5_0_4375_H_2_0 / beam_length, beam_clamped_free5_0_4375_H_2_1 / beam_length,
        beam_clamped_free5_0_4375_H_2_2 / beam_length, beam_clamped_free5_0_4375_H_2_3 / beam_length,
        beam_clamped_free5_0_4375_H_2_4 / beam_length, beam_clamped_free5_0_4375_H_3_0 / beam_length,
        beam_clamped_free5_0_4375_H_3_1 / beam_length, beam_clamped_free5_0_4375_H_3_2 / beam_length,
        beam_clamped_free5_0_4375_H_3_3 / beam_length, beam_clamped_free5_0_4375_H_3_4 / beam_length,
        beam_clamped_free5_0_4375_H_4_0 / beam_length, beam_clamped_free5_0_4375_H_4_1 / beam_length,
        beam_clamped_free5_0_4375_H_4_2 / beam_length, beam_clamped_free5_0_4375_H_4_3 / beam_length,
        beam_clamped_free5_0_4375_H_4_4 / beam_length, beam_clamped_free5_0_5_H_0_0 / beam_length,
        beam_clamped_free5_0_5_H_0_1 / beam_length, beam_clamped_free5_0_5_H_0_2 / beam_length,
        beam_clamped_free5_0_5_H_0_3 / beam_length, beam_clamped_free5_0_5_H_0_4 / beam_length,
        beam_clamped_free5_0_5_H_1_0 / beam_length, beam_clamped_free5_0_5_H_1_1 / beam_length,
        beam_clamped_free5_0_5_H_1_2 / beam_length, beam_clamped_free5_0_5_H_1_3 / beam_length,
        beam_clamped_free5_0_5_H_1_4 / beam_length, beam_clamped_free5_0_5_H_2_0 / beam_length,
        beam_clamped_free5_0_5_H_2_1 / beam_length, beam_clamped_free5_0_5_H_2_2 / beam_length,
        beam_clamped_free5_0_5_H_2_3 / beam_length, beam_clamped_free5_0_5_H_2_4 / beam_length,
        beam_clamped_free5_0_5_H_3_0 / beam_length, beam_clamped_free5_0_5_H_3_1 / beam_length,
        beam_clamped_free5_0_5_H_3_2 / beam_length, beam_clamped_free5_0_5_H_3_3 / beam_length,
        beam_clamped_free5_0_5_H_3_4 / beam_length, beam_clamped_free5_0_5_H_4_0 / beam_length,
        beam_clamped_free5_0_5_H_4_1 / beam_length, beam_clamped_free5_0_5_H_4_2 / beam_length,
        beam_clamped_free5_0_5_H_4_3 / beam_length, beam_clamped_free5_0_5_H_4_4 / beam_length,
        beam_clamped_free5_0_5625_H_0_0 / beam_length, beam_clamped_free5_0_5625_H_0_1 / beam_length,
        beam_clamped_free5_0_5625_H_0_2 / beam_length, beam_clamped_free5_0_5625_H_0_3 / beam_length,
        beam_clamped_free5_0_5625_H_0_4 / beam_length, beam_clamped_free5_0_5625_H_1_0 / beam_length,
        beam_clamped_free5_0_5625_H_1_1 / beam_length, beam_clamped_free5_0_5625_H_1_2 / beam_length,
        beam_clamped_free5_0_5625_H_1_3 / beam_length, beam_clamped_free5_0_5625_H_1_4 / beam_length,
        beam_clamped_free5_0_5625_H_2_0 / beam_length, beam_clamped_free5_0_5625_H_2_1 / beam_length,
        beam_clamped_free5_0_5625_H_2_2 / beam_length, beam_clamped_free5_0_5625_H_2_3 / beam_length,
        beam_clamped_free5_0_5625_H_2_4 / beam_length, beam_clamped_free5_0_5625_H_3_0 / beam_length,
        beam_clamped_free5_0_5625_H_3_1 / beam_length, beam_clamped_free5_0_5625_H_3_2 / beam_length,
        beam_clamped_free5_0_5625_H_3_3 / beam_length, beam_clamped_free5_0_5625_H_3_4 / beam_length,
        beam_clamped_free5_0_5625_H_4_0 / beam_length, beam_clamped_free5_0_5625_H_4_1 / beam_length,
        beam_clamped_free5_0_5625_H_4_2 / beam_length, beam_clamped_free5_0_5625_H_4_3 / beam_length,
        beam_clamped_free5_0_5625_H_4_4 / beam_length, beam_clamped_free5_0_625_H_0_0 / beam_length,
        beam_clamped_free5_0_625_H_0_1 / beam_length, beam_clamped_free5_0_625_H_0_2 / beam_length,
        beam_clamped_free5_0_625_H_0_3 / beam_length, beam_clamped_free5_0_625_H_0_4 / beam_length,
        beam_clamped_free5_0_625_H_1_0 / beam_length, beam_clamped_free5_0_625_H_1_1 / beam_length,
        beam_clamped_free5_0_625_H_1_2 / beam_length, beam_clamped_free5_0_625_H_1_3 / beam_length,
        beam_clamped_free5_0_625_H_1_4 / beam_length, beam_clamped_free5_0_625_H_2_0 / beam_length,
        beam_clamped_free5_0_625_H_2_1 / beam_length, beam_clamped_free5_0_625_H_2_2 / beam_length,
        beam_clamped_free5_0_625_H_2_3 / beam_length, beam_clamped_free5_0_625_H_2_4 / beam_length,
        beam_clamped_free5_0_625_H_3_0 / beam_length, beam_clamped_free5_0_625_H_3_1 / beam_length,
        beam_clamped_free5_0_625_H_3_2 / beam_length, beam_clamped_free5_0_625_H_3_3 / beam_length,
        beam_clamped_free5_0_625_H_3_4 / beam_length, beam_clamped_free5_0_625_H_4_0 / beam_length,
        beam_clamped_free5_0_625_H_4_1 / beam_length, beam_clamped_free5_0_625_H_4_2 / beam_length,
        beam_clamped_free5_0_625_H_4_3 / beam_length, beam_clamped_free5_0_625_H_4_4 / beam_length,
        beam_clamped_free5_0_6875_H_0_0 / beam_length, beam_clamped_free5_0_6875_H_0_1 / beam_length,
        beam_clamped_free5_0_6875_H_0_2 / beam_length, beam_clamped_free5_0_6875_H_0_3 / beam_length,
        beam_clamped_free5_0_6875_H_0_4 / beam_length, beam_clamped_free5_0_6875_H_1_0 / beam_length,
        beam_clamped_free5_0_6875_H_1_1 / beam_length, beam_clamped_free5_0_6875_H_1_2 / beam_length,
        beam_clamped_free5_0_6875_H_1_3 / beam_length, beam_clamped_free5_0_6875_H_1_4 / beam_length,
        beam_clamped_free5_0_6875_H_2_0 / beam_length, beam_clamped_free5_0_6875_H_2_1 / beam_length,
        beam_clamped_free5_0_6875_H_2_2 / beam_length, beam_clamped_free5_0_6875_H_2_3 / beam_length,
        beam_clamped_free5_0_6875_H_2_4 / beam_length, beam_clamped_free5_0_6875_H_3_0 / beam_length,
        beam_clamped_free5_0_6875_H_3_1 / beam_length, beam_clamped_free5_0_6875_H_3_2 / beam_length,
        beam_clamped_free5_0_6875_H_3_3 / beam_length, beam_clamped_free5_0_6875_H_3_4 / beam_length,
        beam_clamped_free5_0_6875_H_4_0 / beam_length, beam_clamped_free5_0_6875_H_4_1 / beam_length,
        beam_clamped_free5_0_6875_H_4_2 / beam_length, beam_clamped_free5_0_6875_H_4_3 / beam_length,
        beam_clamped_free5_0_6875_H_4_4 / beam_length, beam_clamped_free5_0_75_H_0_0 / beam_length,
        beam_clamped_free5_0_75_H_0_1 / beam_length, beam_clamped_free5_0_75_H_0_2 / beam_length,
        beam_clamped_free5_0_75_H_0_3 / beam_length, beam_clamped_free5_0_75_H_0_4 / beam_length,
        beam_clamped_free5_0_75_H_1_0 / beam_length, beam_clamped_free5_0_75_H_1_1 / beam_length,
        beam_clamped_free5_0_75_H_1_2 / beam_length, beam_clamped_free5_0_75_H_1_3 / beam_length,
        beam_clamped_free5_0_75_H_1_4 / beam_length, beam_clamped_free5_0_75_H_2_0 / beam_length,
        beam_clamped_free5_0_75_H_2_1 / beam_length, beam_clamped_free5_0_75_H_2_2 / beam_length,
        beam_clamped_free5_0_75_H_2_3 / beam_length, beam_clamped_free5_0_75_H_2_4 / beam_length,
        beam_clamped_free5_0_75_H_3_0 / beam_length, beam_clamped_free5_0_75_H_3_1 / beam_length,
        beam_clamped_free5_0_75_H_3_2 / beam_length, beam_clamped_free5_0_75_H_3_3 / beam_length,
        beam_clamped_free5_0_75_H_3_4 / beam_length, beam_clamped_free5_0_75_H_4_0 / beam_length,
        beam_clamped_free5_0_75_H_4_1 / beam_length, beam_clamped_free5_0_75_H_4_2 / beam_length,
        beam_clamped_free5_0_75_H_4_3 / beam_length, beam_clamped_free5_0_75_H_4_4 / beam_length,
        beam_clamped_free5_0_8125_H_0_0 / beam_length, beam_clamped_free5_0_8125_H_0_1 / beam_length,
        beam_clamped_free5_0_8125_H_0_2 / beam_length, beam_clamped_free5_0_8125_H_0_3 / beam_length,
        beam_clamped_free5_0_8125_H_0_4 / beam_length, beam_clamped_free5_0_8125_H_1_0 / beam_length,
        beam_clamped_free5_0_8125_H_1_1 / beam_length, beam_clamped_free5_0_8125_H_1_2 / beam_length,
        beam_clamped_free5_0_8125_H_1_3 / beam_length, beam_clamped_free5_0_8125_H_1_4 / beam_length,
        beam_clamped_free5_0_8125_H_2_0 / beam_length, beam_clamped_free5_0_8125_H_2_1 / beam_length,
        beam_clamped_free5_0_8125_H_2_2 / beam_length, beam_clamped_free5_0_8125_H_2_3 / beam_length,
        beam_clamped_free5_0_8125_H_2_4 / beam_length, beam_clamped_free5_0_8125_H_3_0 / beam_length,
        beam_clamped_free5_0_8125_H_3_1 / beam_length, beam_clamped_free5_0_8125_H_3_2 / beam_length,
        beam_clamped_free5_0_8125_H_3_3 / beam_length, beam_clamped_free5_0_8125_H_3_4 / beam_length,
        beam_clamped_free5_0_8125_H_4_0 / beam_length, beam_clamped_free5_0_8125_H_4_1 / beam_length,
        beam_clamped_free5_0_8125_H_4_2 / beam_length, beam_clamped_free5_0_8125_H_4_3 / beam_length,
        beam_clamped_free5_0_8125_H_4_4 / beam_length, beam_clamped_free5_0_875_H_0_0 / beam_length,
        beam_clamped_free5_0_875_H_0_1 / beam_length, beam_clamped_free5_0_875_H_0_2 / beam_length,
        beam_clamped_free5_0_875_H_0_3 / beam_length, beam_clamped_free5_0_875_H_0_4 / beam_length,
        beam_clamped_free5_0_875_H_1_0 / beam_length, beam_clamped_free5_0_875_H_1_1 / beam_length,
        beam_clamped_free5_0_875_H_1_2 / beam_length, beam_clamped_free5_0_875_H_1_3 / beam_length,
        beam_clamped_free5_0_875_H_1_4 / beam_length, beam_clamped_free5_0_875_H_2_0 / beam_length,
        beam_clamped_free5_0_875_H_2_1 / beam_length, beam_clamped_free5_0_875_H_2_2 / beam_length,
        beam_clamped_free5_0_875_H_2_3 / beam_length, beam_clamped_free5_0_875_H_2_4 / beam_length,
        beam_clamped_free5_0_875_H_3_0 / beam_length, beam_clamped_free5_0_875_H_3_1 / beam_length,
        beam_clamped_free5_0_875_H_3_2 / beam_length, beam_clamped_free5_0_875_H_3_3 / beam_length,
        beam_clamped_free5_0_875_H_3_4 / beam_length, beam_clamped_free5_0_875_H_4_0 / beam_length,
        beam_clamped_free5_0_875_H_4_1 / beam_length, beam_clamped_free5_0_875_H_4_2 / beam_length,
        beam_clamped_free5_0_875_H_4_3 / beam_length, beam_clamped_free5_0_875_H_4_4 / beam_length,
        beam_clamped_free5_0_9375_H_0_0 / beam_length, beam_clamped_free5_0_9375_H_0_1 / beam_length,
        beam_clamped_free5_0_9375_H_0_2 / beam_length, beam_clamped_free5_0_9375_H_0_3 / beam_length,
        beam_clamped_free5_0_9375_H_0_4 / beam_length, beam_clamped_free5_0_9375_H_1_0 / beam_length,
        beam_clamped_free5_0_9375_H_1_1 / beam_length, beam_clamped_free5_0_9375_H_1_2 / beam_length,
        beam_clamped_free5_0_9375_H_1_3 / beam_length, beam_clamped_free5_0_9375_H_1_4 / beam_length,
        beam_clamped_free5_0_9375_H_2_0 / beam_length, beam_clamped_free5_0_9375_H_2_1 / beam_length,
        beam_clamped_free5_0_9375_H_2_2 / beam_length, beam_clamped_free5_0_9375_H_2_3 / beam_length,
        beam_clamped_free5_0_9375_H_2_4 / beam_length, beam_clamped_free5_0_9375_H_3_0 / beam_length,
        beam_clamped_free5_0_9375_H_3_1 / beam_length, beam_clamped_free5_0_9375_H_3_2 / beam_length,
        beam_clamped_free5_0_9375_H_3_3 / beam_length, beam_clamped_free5_0_9375_H_3_4 / beam_length,
        beam_clamped_free5_0_9375_H_4_0 / beam_length, beam_clamped_free5_0_9375_H_4_1 / beam_length,
        beam_clamped_free5_0_9375_H_4_2 / beam_length, beam_clamped_free5_0_9375_H_4_3 / beam_length,
        beam_clamped_free5_0_9375_H_4_4 / beam_length, w5, w6, w7, w8, w9, w10, w11, w12, w13, w14, w15, w16,
        w17, w18, w19, w20, w21, w22, w23, w24, w25, w26, w27, w28, w29, w5, w6, w7, w8, w9, w10, w11, w12, w13,
        w14, w15, w16, w17, w18, w19, w20, w21, w22, w23, w24, w25, w26, w27, w28, w29,
    )
    sections = ca.vertcat(w30, beam_area / w30)
    rigidities = ca.vertcat(beam_youngs_modulus * beam_second_moment, 0.0)
    inputs, outputs = [p], [ca.densify(positions), ca.densify(axes), ca.densify(shapes), ca.densify(turns), ca.densify(H), ca.densify(sections), ca.densify(rigidities)]
    return ca.Function("geometry", inputs, outputs, ["p"], ["positions", "axes", "shapes", "turns", "H", "sections", "rigidities"])


FUNCTIONS = {
    "constants": constants,
    "condensed": condensed,
    "closure": closure,
    "velocities": velocities,
    "accelerations": accelerations,
    "constraints": constraints,
    "augmented": augmented,
    "reactions": reactions,
    "energy": energy,
    "measures": measures,
    "poses": poses,
    "switching": switching,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "residual_jacobian": residual_jacobian,
    "deflections": deflections,
    "forward_dynamics": forward_dynamics,
    "geometry": geometry,
}
