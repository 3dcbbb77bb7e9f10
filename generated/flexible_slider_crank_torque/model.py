"""Flexible slider-crank, driven by a torque: equations of motion, emitted by symgen from the scene `flexible_slider_crank_torque`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 397 operations."""
    p = ca.SX.sym("p", 168)
    motor_torque = p[0]
    gravity_y = p[1]
    crank_mass = p[2]
    crank_inertia = p[3]
    crank_center_of_mass_x = p[4]
    rod_length = p[5]
    rod_density = p[6]
    rod_area = p[7]
    rod_youngs_modulus = p[8]
    rod_second_moment = p[9]
    beam20_pinned_pinned2_kappa_lateral_0_0 = p[10]
    beam20_pinned_pinned2_kappa_lateral_1_1 = p[11]
    beam20_pinned_pinned2_mass_0_0 = p[12]
    beam20_pinned_pinned2_mass_1_1 = p[13]
    rod_damping_ratio = p[14]
    beam20_pinned_pinned2_s1_0_0 = p[15]
    beam20_pinned_pinned2_i0_0_0 = p[16]
    beam20_pinned_pinned2_phi_y_0_0 = p[17]
    beam20_pinned_pinned2_xi_phi_y_0_0 = p[18]
    beam20_pinned_pinned2_xi_phi_y_1_0 = p[19]
    beam20_pinned_pinned2_H_0_0 = p[20]
    beam20_pinned_pinned2_H_0_1 = p[21]
    beam20_pinned_pinned2_H_1_0 = p[22]
    beam20_pinned_pinned2_H_1_1 = p[23]
    beam20_pinned_pinned2_xH_0_0 = p[24]
    beam20_pinned_pinned2_xH_0_1 = p[25]
    beam20_pinned_pinned2_xH_1_0 = p[26]
    beam20_pinned_pinned2_xH_1_1 = p[27]
    slider_mass = p[28]
    slider_inertia = p[29]
    crank_tip_x = p[30]
    beam20_pinned_pinned2_1_0_H_0_0 = p[35]
    beam20_pinned_pinned2_1_0_H_1_1 = p[36]
    beam20_pinned_pinned2_0_0625_at_0_0 = p[37]
    beam20_pinned_pinned2_0_0625_shape_1_0 = p[38]
    beam20_pinned_pinned2_0_0625_shape_1_1 = p[39]
    beam20_pinned_pinned2_0_0625_H_0_0 = p[42]
    beam20_pinned_pinned2_0_0625_H_0_1 = p[43]
    beam20_pinned_pinned2_0_0625_H_1_0 = p[44]
    beam20_pinned_pinned2_0_0625_H_1_1 = p[45]
    beam20_pinned_pinned2_0_125_at_0_0 = p[46]
    beam20_pinned_pinned2_0_125_shape_1_0 = p[47]
    beam20_pinned_pinned2_0_125_shape_1_1 = p[48]
    beam20_pinned_pinned2_0_125_H_0_0 = p[51]
    beam20_pinned_pinned2_0_125_H_0_1 = p[52]
    beam20_pinned_pinned2_0_125_H_1_0 = p[53]
    beam20_pinned_pinned2_0_125_H_1_1 = p[54]
    beam20_pinned_pinned2_0_1875_at_0_0 = p[55]
    beam20_pinned_pinned2_0_1875_shape_1_0 = p[56]
    beam20_pinned_pinned2_0_1875_shape_1_1 = p[57]
    beam20_pinned_pinned2_0_1875_H_0_0 = p[60]
    beam20_pinned_pinned2_0_1875_H_0_1 = p[61]
    beam20_pinned_pinned2_0_1875_H_1_0 = p[62]
    beam20_pinned_pinned2_0_1875_H_1_1 = p[63]
    beam20_pinned_pinned2_0_25_at_0_0 = p[64]
    beam20_pinned_pinned2_0_25_shape_1_0 = p[65]
    beam20_pinned_pinned2_0_25_shape_1_1 = p[66]
    beam20_pinned_pinned2_0_25_H_0_0 = p[68]
    beam20_pinned_pinned2_0_25_H_0_1 = p[69]
    beam20_pinned_pinned2_0_25_H_1_0 = p[70]
    beam20_pinned_pinned2_0_25_H_1_1 = p[71]
    beam20_pinned_pinned2_0_3125_at_0_0 = p[72]
    beam20_pinned_pinned2_0_3125_shape_1_0 = p[73]
    beam20_pinned_pinned2_0_3125_shape_1_1 = p[74]
    beam20_pinned_pinned2_0_3125_H_0_0 = p[77]
    beam20_pinned_pinned2_0_3125_H_0_1 = p[78]
    beam20_pinned_pinned2_0_3125_H_1_0 = p[79]
    beam20_pinned_pinned2_0_3125_H_1_1 = p[80]
    beam20_pinned_pinned2_0_375_at_0_0 = p[81]
    beam20_pinned_pinned2_0_375_shape_1_0 = p[82]
    beam20_pinned_pinned2_0_375_shape_1_1 = p[83]
    beam20_pinned_pinned2_0_375_H_0_0 = p[86]
    beam20_pinned_pinned2_0_375_H_0_1 = p[87]
    beam20_pinned_pinned2_0_375_H_1_0 = p[88]
    beam20_pinned_pinned2_0_375_H_1_1 = p[89]
    beam20_pinned_pinned2_0_4375_at_0_0 = p[90]
    beam20_pinned_pinned2_0_4375_shape_1_0 = p[91]
    beam20_pinned_pinned2_0_4375_shape_1_1 = p[92]
    beam20_pinned_pinned2_0_4375_H_0_0 = p[95]
    beam20_pinned_pinned2_0_4375_H_0_1 = p[96]
    beam20_pinned_pinned2_0_4375_H_1_0 = p[97]
    beam20_pinned_pinned2_0_4375_H_1_1 = p[98]
    beam20_pinned_pinned2_0_5_at_0_0 = p[99]
    beam20_pinned_pinned2_0_5_shape_1_0 = p[100]
    beam20_pinned_pinned2_0_5_H_0_0 = p[102]
    beam20_pinned_pinned2_0_5_H_0_1 = p[103]
    beam20_pinned_pinned2_0_5_H_1_0 = p[104]
    beam20_pinned_pinned2_0_5_H_1_1 = p[105]
    beam20_pinned_pinned2_0_5625_at_0_0 = p[106]
    beam20_pinned_pinned2_0_5625_shape_1_0 = p[107]
    beam20_pinned_pinned2_0_5625_shape_1_1 = p[108]
    beam20_pinned_pinned2_0_5625_H_0_0 = p[111]
    beam20_pinned_pinned2_0_5625_H_0_1 = p[112]
    beam20_pinned_pinned2_0_5625_H_1_0 = p[113]
    beam20_pinned_pinned2_0_5625_H_1_1 = p[114]
    beam20_pinned_pinned2_0_625_at_0_0 = p[115]
    beam20_pinned_pinned2_0_625_shape_1_0 = p[116]
    beam20_pinned_pinned2_0_625_shape_1_1 = p[117]
    beam20_pinned_pinned2_0_625_H_0_0 = p[120]
    beam20_pinned_pinned2_0_625_H_0_1 = p[121]
    beam20_pinned_pinned2_0_625_H_1_0 = p[122]
    beam20_pinned_pinned2_0_625_H_1_1 = p[123]
    beam20_pinned_pinned2_0_6875_at_0_0 = p[124]
    beam20_pinned_pinned2_0_6875_shape_1_0 = p[125]
    beam20_pinned_pinned2_0_6875_shape_1_1 = p[126]
    beam20_pinned_pinned2_0_6875_H_0_0 = p[129]
    beam20_pinned_pinned2_0_6875_H_0_1 = p[130]
    beam20_pinned_pinned2_0_6875_H_1_0 = p[131]
    beam20_pinned_pinned2_0_6875_H_1_1 = p[132]
    beam20_pinned_pinned2_0_75_at_0_0 = p[133]
    beam20_pinned_pinned2_0_75_shape_1_0 = p[134]
    beam20_pinned_pinned2_0_75_shape_1_1 = p[135]
    beam20_pinned_pinned2_0_75_H_0_0 = p[137]
    beam20_pinned_pinned2_0_75_H_0_1 = p[138]
    beam20_pinned_pinned2_0_75_H_1_0 = p[139]
    beam20_pinned_pinned2_0_75_H_1_1 = p[140]
    beam20_pinned_pinned2_0_8125_at_0_0 = p[141]
    beam20_pinned_pinned2_0_8125_shape_1_0 = p[142]
    beam20_pinned_pinned2_0_8125_shape_1_1 = p[143]
    beam20_pinned_pinned2_0_8125_H_0_0 = p[146]
    beam20_pinned_pinned2_0_8125_H_0_1 = p[147]
    beam20_pinned_pinned2_0_8125_H_1_0 = p[148]
    beam20_pinned_pinned2_0_8125_H_1_1 = p[149]
    beam20_pinned_pinned2_0_875_at_0_0 = p[150]
    beam20_pinned_pinned2_0_875_shape_1_0 = p[151]
    beam20_pinned_pinned2_0_875_shape_1_1 = p[152]
    beam20_pinned_pinned2_0_875_H_0_0 = p[155]
    beam20_pinned_pinned2_0_875_H_0_1 = p[156]
    beam20_pinned_pinned2_0_875_H_1_0 = p[157]
    beam20_pinned_pinned2_0_875_H_1_1 = p[158]
    beam20_pinned_pinned2_0_9375_at_0_0 = p[159]
    beam20_pinned_pinned2_0_9375_shape_1_0 = p[160]
    beam20_pinned_pinned2_0_9375_shape_1_1 = p[161]
    beam20_pinned_pinned2_0_9375_H_0_0 = p[164]
    beam20_pinned_pinned2_0_9375_H_0_1 = p[165]
    beam20_pinned_pinned2_0_9375_H_1_0 = p[166]
    beam20_pinned_pinned2_0_9375_H_1_1 = p[167]
    w0 = rod_density * rod_area
    w1 = w0 * rod_length
    w2 = w1 * rod_length
    w3 = w1 * beam20_pinned_pinned2_mass_0_0
    w4 = w1 * beam20_pinned_pinned2_xH_0_0
    w5 = w1 * beam20_pinned_pinned2_mass_1_1
    w6 = w1 * beam20_pinned_pinned2_xH_1_1
    w7 = rod_length**2
    w8 = rod_youngs_modulus * rod_second_moment / (rod_length * w7)
    w9 = w8 * beam20_pinned_pinned2_kappa_lateral_0_0
    w10 = 2 * rod_damping_ratio
    w11 = w8 * beam20_pinned_pinned2_kappa_lateral_1_1
    c = ca.vertcat(
        crank_tip_x,
        w1,
        crank_inertia + crank_mass * crank_center_of_mass_x**2,
        w1 + slider_mass,
        beam20_pinned_pinned2_1_0_H_0_0 / rod_length,
        beam20_pinned_pinned2_1_0_H_1_1 / rod_length,
        rod_length,
        w0 * beam20_pinned_pinned2_H_0_0,
        w0 * beam20_pinned_pinned2_H_0_1,
        w0 * beam20_pinned_pinned2_H_1_0,
        w0 * beam20_pinned_pinned2_H_1_1,
        w2 * beam20_pinned_pinned2_s1_0_0,
        w1 * beam20_pinned_pinned2_phi_y_0_0,
        slider_mass,
        w3,
        w4,
        w1 * beam20_pinned_pinned2_xH_0_1,
        w5,
        w1 * beam20_pinned_pinned2_xH_1_0,
        w6,
        w1 * w7 * beam20_pinned_pinned2_i0_0_0,
        w2 * beam20_pinned_pinned2_xi_phi_y_0_0,
        w2 * beam20_pinned_pinned2_xi_phi_y_1_0,
        crank_mass * crank_center_of_mass_x,
        gravity_y,
        motor_torque,
        w1 * gravity_y,
        w9,
        w10 * ca.sqrt(w9 * w3),
        w11,
        w10 * ca.sqrt(w11 * w5),
        crank_mass * gravity_y,
        crank_mass,
        slider_inertia,
        slider_mass * gravity_y,
        beam20_pinned_pinned2_0_0625_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_0625_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_0625_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_0625_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_0625_at_0_0,
        beam20_pinned_pinned2_0_0625_shape_1_0,
        beam20_pinned_pinned2_0_0625_shape_1_1,
        beam20_pinned_pinned2_0_125_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_125_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_125_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_125_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_125_at_0_0,
        beam20_pinned_pinned2_0_125_shape_1_0,
        beam20_pinned_pinned2_0_125_shape_1_1,
        beam20_pinned_pinned2_0_1875_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_1875_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_1875_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_1875_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_1875_at_0_0,
        beam20_pinned_pinned2_0_1875_shape_1_0,
        beam20_pinned_pinned2_0_1875_shape_1_1,
        beam20_pinned_pinned2_0_25_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_25_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_25_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_25_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_25_at_0_0,
        beam20_pinned_pinned2_0_25_shape_1_0,
        beam20_pinned_pinned2_0_25_shape_1_1,
        beam20_pinned_pinned2_0_3125_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_3125_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_3125_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_3125_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_3125_at_0_0,
        beam20_pinned_pinned2_0_3125_shape_1_0,
        beam20_pinned_pinned2_0_3125_shape_1_1,
        beam20_pinned_pinned2_0_375_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_375_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_375_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_375_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_375_at_0_0,
        beam20_pinned_pinned2_0_375_shape_1_0,
        beam20_pinned_pinned2_0_375_shape_1_1,
        beam20_pinned_pinned2_0_4375_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_4375_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_4375_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_4375_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_4375_at_0_0,
        beam20_pinned_pinned2_0_4375_shape_1_0,
        beam20_pinned_pinned2_0_4375_shape_1_1,
        beam20_pinned_pinned2_0_5_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_5_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_5_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_5_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_5_at_0_0,
        beam20_pinned_pinned2_0_5_shape_1_0,
        beam20_pinned_pinned2_0_5625_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_5625_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_5625_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_5625_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_5625_at_0_0,
        beam20_pinned_pinned2_0_5625_shape_1_0,
        beam20_pinned_pinned2_0_5625_shape_1_1,
        beam20_pinned_pinned2_0_625_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_625_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_625_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_625_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_625_at_0_0,
        beam20_pinned_pinned2_0_625_shape_1_0,
        beam20_pinned_pinned2_0_625_shape_1_1,
        beam20_pinned_pinned2_0_6875_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_6875_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_6875_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_6875_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_6875_at_0_0,
        beam20_pinned_pinned2_0_6875_shape_1_0,
        beam20_pinned_pinned2_0_6875_shape_1_1,
        beam20_pinned_pinned2_0_75_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_75_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_75_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_75_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_75_at_0_0,
        beam20_pinned_pinned2_0_75_shape_1_0,
        beam20_pinned_pinned2_0_75_shape_1_1,
        beam20_pinned_pinned2_0_8125_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_8125_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_8125_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_8125_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_8125_at_0_0,
        beam20_pinned_pinned2_0_8125_shape_1_0,
        beam20_pinned_pinned2_0_8125_shape_1_1,
        beam20_pinned_pinned2_0_875_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_875_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_875_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_875_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_875_at_0_0,
        beam20_pinned_pinned2_0_875_shape_1_0,
        beam20_pinned_pinned2_0_875_shape_1_1,
        beam20_pinned_pinned2_0_9375_H_0_0 / rod_length,
        beam20_pinned_pinned2_0_9375_H_0_1 / rod_length,
        beam20_pinned_pinned2_0_9375_H_1_0 / rod_length,
        beam20_pinned_pinned2_0_9375_H_1_1 / rod_length,
        rod_length * beam20_pinned_pinned2_0_9375_at_0_0,
        beam20_pinned_pinned2_0_9375_shape_1_0,
        beam20_pinned_pinned2_0_9375_shape_1_1,
        w3 - w4,
        w5 - w6,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 315 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 141)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
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
    c11 = c[11]
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
    w0 = ca.cos(crank_theta)
    w1 = w0 * c0
    w2 = ca.sin(crank_theta) * c0
    w3 = ca.cos(rod_theta)
    w4 = c4 * rod_q1
    w5 = c5 * rod_q2
    w6 = c6 - (rod_q1 * w4 + rod_q2 * w5) / 2.0
    w7 = w3 * w6
    w8 = w1 / w7
    w9 = c7 * rod_q1 + c8 * rod_q2
    w10 = c9 * rod_q1 + c10 * rod_q2
    w11 = c11 - (rod_q1 * w9 + rod_q2 * w10) / 2.0
    w12 = ca.sin(rod_theta)
    w13 = c12 * rod_q1
    w14 = w3 * w11 - w12 * w13
    w15 = w12 * w11 + w3 * w13
    w16 = w12 * w6
    w17 = w16 * c13
    w18 = w1 * w14 + w2 * (w15 + w17)
    w19 = c14 * rod_q1 - (c15 * rod_q1 + c16 * rod_q2)
    w20 = c17 * rod_q2 - (c18 * rod_q1 + c19 * rod_q2)
    w21 = c20 + (rod_q1 * w19 + rod_q2 * w20)
    w22 = w21 + w16 * w17
    w23 = w3 * c12 - w12 * w9
    w24 = w3 * w9 + w12 * c12
    w25 = w3 * w4
    w26 = w25 * c13
    w27 = w12 * w4 / w7
    w28 = c21 + w16 * w26
    w29 = w28 + w27 * w22
    w30 = w1 * w23 + w2 * (w24 + w26) + (w27 * w18 - w8 * w29)
    w31 = w3 * w10
    w32 = w3 * w5
    w33 = w32 * c13
    w34 = w12 * w10
    w35 = w12 * w5 / w7
    w36 = c22 + w16 * w33
    w37 = w36 + w35 * w22
    w38 = w2 * (w31 + w33) - w1 * w34 + (w35 * w18 - w8 * w37)
    w39 = w25 * w33 + (w27 * w37 + w35 * w28)
    w40 = rod_theta_dot**2
    w41 = rod_q1_dot * (c7 * rod_q1_dot + c8 * rod_q2_dot) + rod_q2_dot * (c9 * rod_q1_dot + c10 * rod_q2_dot)
    w42 = w9 * rod_q1_dot + w10 * rod_q2_dot
    w43 = c12 * rod_q1_dot
    w44 = crank_theta_dot**2
    w45 = w2 * w44
    w46 = w4 * rod_q1_dot + w5 * rod_q2_dot
    w47 = rod_q1_dot * (c4 * rod_q1_dot) + rod_q2_dot * (c5 * rod_q2_dot)
    w48 = (2 * -(w3 * w46) * rod_theta_dot - w12 * w47 - w16 * w40 - w45) / w7
    w49 = w15 * w40 + w12 * w41 - 2 * -(w3 * w42 + w12 * w43) * rod_theta_dot + c26 + (c1 * w45 + w14 * w48)
    w50 = w1 * w44
    w51 = c13 * (w16 * w48 - (w3 * w47 + w7 * w40 + 2 * -(w12 * w46) * rod_theta_dot + w50))
    w52 = (w14 * w40 + 2 * (w3 * w43 - w12 * w42) * rod_theta_dot + w3 * w41 - (w15 * w48 - c1 * w50) - w51) * w2
    w53 = -2.0 * (w19 * rod_q1_dot + w20 * rod_q2_dot) * rod_theta_dot + w14 * c24 - (w15 * w50 - w14 * w45 - w21 * w48)
    w54 = w53 + w51 * w16
    w55 = w19 * w40 - (c27 * rod_q1 + c28 * rod_q1_dot) + w23 * c24 - (w24 * w50 - w23 * w45 - c21 * w48) + w51 * w25
    w56 = w20 * w40 - (c29 * rod_q2 + c30 * rod_q2_dot) - w34 * c24 - (w31 * w50 + w34 * w45 - c22 * w48) + w51 * w32
    M_hat = ca.vertcat(
        c2 + w1 * (w1 * c1) + w2 * (w2 * c3) - (w8 * (w18 - w8 * w22) + w8 * w18),
        w30,
        w38,
        w30,
        c14 + w25 * w26 + (w27 * w29 + w27 * w28),
        w39,
        w38,
        w39,
        c17 + w32 * w33 + (w35 * w37 + w35 * w36),
    )
    M_hat = ca.reshape(M_hat, 3, 3)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w0 * c23 * c24 + ca.if_else(t < 0.15, c25, 0) + w49 * w1 - w52 - w54 * w8,
        w55 + w54 * w27,
        w56 + w54 * w35,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, t, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "t", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d in closed form (Eq. 31); C_loop before the step. 41 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    c = ca.SX.sym("c", 141)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.sin(crank_theta) * c0
    w2 = c6 - (rod_q1 * (c4 * rod_q1) + rod_q2 * (c5 * rod_q2)) / 2.0
    w3 = w1 + ca.sin(rod_theta) * w2
    w4 = rod_theta - w3 / (ca.cos(rod_theta) * w2)
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        w0,
        w1,
        w4,
        w0 + ca.cos(w4) * w2,
        0.0,
        0.0,
    )
    q_d_next = ca.densify(q_d_next)
    C_loop = ca.vertcat(
        -w3,
    )
    C_loop = ca.densify(C_loop)
    inputs, outputs = [q_i, q_d, c], [q_d_next, C_loop]
    return ca.Function("closure", inputs, outputs, ["q_i", "q_d", "c"], ["q_d_next", "C_loop"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 58 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    c = ca.SX.sym("c", 141)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    w0 = ca.sin(crank_theta) * c0 * crank_theta_dot
    w1 = ca.cos(crank_theta) * c0
    w2 = ca.sin(rod_theta)
    w3 = c4 * rod_q1
    w4 = ca.cos(rod_theta)
    w5 = c5 * rod_q2
    w6 = c6 - (rod_q1 * w3 + rod_q2 * w5) / 2.0
    w7 = w4 * w6
    w8 = w2 * w3 / w7 * rod_q1_dot - w1 / w7 * crank_theta_dot + w2 * w5 / w7 * rod_q2_dot
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        -w0,
        w1 * crank_theta_dot,
        w8,
        -(w0 + w2 * w6 * w8 + w4 * w3 * rod_q1_dot + w4 * w5 * rod_q2_dot),
        0.0,
        0.0,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i", "q_d", "q_i_dot", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 96 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 141)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_i_ddot[0]
    rod_q1_ddot = q_i_ddot[1]
    rod_q2_ddot = q_i_ddot[2]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    w0 = ca.cos(crank_theta) * c0
    w1 = crank_theta_dot**2
    w2 = ca.sin(crank_theta) * c0
    w3 = w0 * w1 + w2 * crank_theta_ddot
    w4 = w2 * w1
    w5 = ca.sin(rod_theta)
    w6 = c4 * rod_q1
    w7 = ca.cos(rod_theta)
    w8 = c5 * rod_q2
    w9 = c6 - (rod_q1 * w6 + rod_q2 * w8) / 2.0
    w10 = w7 * w9
    w11 = w6 * rod_q1_dot + w8 * rod_q2_dot
    w12 = rod_q1_dot * (c4 * rod_q1_dot) + rod_q2_dot * (c5 * rod_q2_dot)
    w13 = w5 * w9
    w14 = rod_theta_dot**2
    w15 = (2 * -(w7 * w11) * rod_theta_dot - w5 * w12 - w13 * w14 - w4) / w10 + w0 / w10 * crank_theta_ddot
    w16 = w5 * w6 / w10 * rod_q1_ddot - w15 + w5 * w8 / w10 * rod_q2_ddot
    w17 = w7 * w12 + w10 * w14 + 2 * -(w5 * w11) * rod_theta_dot + w3 + w13 * w16 + w7 * w6 * rod_q1_ddot + w7 * w8 * rod_q2_ddot
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        -w3,
        w0 * crank_theta_ddot - w4,
        w16,
        -w17,
        0.0,
        0.0,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_i_ddot, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t and gamma in all coordinates (Eqs. 21-27). 195 operations."""
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    c = ca.SX.sym("c", 141)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    slider_x = q[8]
    slider_y = q[9]
    slider_theta = q[10]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.sin(crank_theta) * c0
    w2 = ca.cos(rod_theta)
    w3 = c4 * rod_q1
    w4 = c5 * rod_q2
    w5 = c6 - (rod_q1 * w3 + rod_q2 * w4) / 2.0
    w6 = w2 * w5
    w7 = ca.sin(rod_theta)
    w8 = w7 * w5
    w9 = crank_theta_dot**2
    w10 = rod_q1_dot * (c4 * rod_q1_dot) + rod_q2_dot * (c5 * rod_q2_dot)
    w11 = rod_theta_dot**2
    w12 = w3 * rod_q1_dot + w4 * rod_q2_dot
    C = ca.vertcat(
        crank_x,
        crank_y,
        rod_x - (crank_x + w0),
        rod_y - (crank_y + w1),
        slider_y,
        slider_theta,
        slider_x - (rod_x + w6),
        slider_y - (rod_y + w8),
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w1,
        -w0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w8,
        -w6,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w2 * w3,
        w7 * w3,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w2 * w4,
        w7 * w4,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 8, 11)
    C_q = ca.densify(C_q)
    C_t = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    C_t = ca.densify(C_t)
    gamma = ca.vertcat(
        0.0,
        0.0,
        -(w0 * w9),
        -(w1 * w9),
        0.0,
        0.0,
        -(w2 * w10 + w6 * w11 + 2 * -(w7 * w12) * rod_theta_dot),
        2 * -(w2 * w12) * rod_theta_dot - w7 * w10 - w8 * w11,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, q_dot, c], [C, C_q, C_t, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "q_dot", "c"], ["C", "C_q", "C_t", "gamma"])


def augmented() -> ca.Function:
    """M and Q* of the augmented form (Eq. 28). 289 operations."""
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 141)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    c1 = c[1]
    c2 = c[2]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
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
    w0 = ca.sin(crank_theta) * c23
    w1 = -w0
    w2 = ca.cos(crank_theta) * c23
    w3 = ca.sin(rod_theta)
    w4 = c7 * rod_q1 + c8 * rod_q2
    w5 = c9 * rod_q1 + c10 * rod_q2
    w6 = c11 - (rod_q1 * w4 + rod_q2 * w5) / 2.0
    w7 = ca.cos(rod_theta)
    w8 = c12 * rod_q1
    w9 = w3 * w6 + w7 * w8
    w10 = -w9
    w11 = -(w7 * w4 + w3 * c12)
    w12 = -(w7 * w5)
    w13 = w7 * w6 - w3 * w8
    w14 = w7 * c12 - w3 * w4
    w15 = w3 * w5
    w16 = -w15
    w17 = c14 * rod_q1 - (c15 * rod_q1 + c16 * rod_q2)
    w18 = c17 * rod_q2 - (c18 * rod_q1 + c19 * rod_q2)
    w19 = crank_theta_dot**2
    w20 = rod_theta_dot**2
    w21 = c12 * rod_q1_dot
    w22 = w4 * rod_q1_dot + w5 * rod_q2_dot
    w23 = rod_q1_dot * (c7 * rod_q1_dot + c8 * rod_q2_dot) + rod_q2_dot * (c9 * rod_q1_dot + c10 * rod_q2_dot)
    M = ca.vertcat(
        c32,
        0.0,
        w1,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c32,
        w2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w1,
        w2,
        c2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
        0.0,
        w10,
        w11,
        w12,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
        w13,
        w14,
        w16,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w10,
        w13,
        c20 + (rod_q1 * w17 + rod_q2 * w18),
        c21,
        c22,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w11,
        w14,
        c21,
        c14,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w12,
        w16,
        c22,
        0.0,
        c17,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c13,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c13,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c33,
    )
    M = ca.reshape(M, 11, 11)
    M = ca.densify(M)
    Q_star = ca.vertcat(
        w2 * w19,
        w0 * w19 + c31,
        w2 * c24 + ca.if_else(t < 0.15, c25, 0),
        w13 * w20 + 2 * (w7 * w21 - w3 * w22) * rod_theta_dot + w7 * w23,
        w9 * w20 + w3 * w23 - 2 * -(w7 * w22 + w3 * w21) * rod_theta_dot + c26,
        -2.0 * (w17 * rod_q1_dot + w18 * rod_q2_dot) * rod_theta_dot + w13 * c24,
        w17 * w20 - (c27 * rod_q1 + c28 * rod_q1_dot) + w14 * c24,
        w18 * w20 - (c29 * rod_q2 + c30 * rod_q2_dot) - w15 * c24,
        0.0,
        c34,
        0.0,
    )
    Q_star = ca.densify(Q_star)
    inputs, outputs = [q, q_dot, t, c], [M, Q_star]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "t", "c"], ["M", "Q_star"])


def reactions() -> ca.Function:
    """Lagrange multipliers lam (Eq. 37). 205 operations."""
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    q_ddot = ca.SX.sym("q_ddot", 11)
    c = ca.SX.sym("c", 141)
    crank_theta = q[2]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    crank_theta_dot = q_dot[2]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    crank_x_ddot = q_ddot[0]
    crank_y_ddot = q_ddot[1]
    crank_theta_ddot = q_ddot[2]
    rod_x_ddot = q_ddot[3]
    rod_y_ddot = q_ddot[4]
    rod_theta_ddot = q_ddot[5]
    rod_q1_ddot = q_ddot[6]
    rod_q2_ddot = q_ddot[7]
    slider_x_ddot = q_ddot[8]
    slider_y_ddot = q_ddot[9]
    slider_theta_ddot = q_ddot[10]
    c1 = c[1]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
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
    c26 = c[26]
    c31 = c[31]
    c32 = c[32]
    c33 = c[33]
    c34 = c[34]
    w0 = ca.cos(crank_theta) * c23
    w1 = crank_theta_dot**2
    w2 = ca.sin(crank_theta) * c23
    w3 = ca.cos(rod_theta)
    w4 = c7 * rod_q1 + c8 * rod_q2
    w5 = c9 * rod_q1 + c10 * rod_q2
    w6 = c11 - (rod_q1 * w4 + rod_q2 * w5) / 2.0
    w7 = ca.sin(rod_theta)
    w8 = c12 * rod_q1
    w9 = w3 * w6 - w7 * w8
    w10 = rod_theta_dot**2
    w11 = c12 * rod_q1_dot
    w12 = w4 * rod_q1_dot + w5 * rod_q2_dot
    w13 = rod_q1_dot * (c7 * rod_q1_dot + c8 * rod_q2_dot) + rod_q2_dot * (c9 * rod_q1_dot + c10 * rod_q2_dot)
    w14 = w7 * w6 + w3 * w8
    w15 = c1 * rod_x_ddot - w14 * rod_theta_ddot - (w3 * w4 + w7 * c12) * rod_q1_ddot - w3 * w5 * rod_q2_ddot
    w16 = c13 * slider_x_ddot
    w17 = w9 * w10 + 2 * (w3 * w11 - w7 * w12) * rod_theta_dot + w3 * w13 - w15 - w16
    w18 = c1 * rod_y_ddot + w9 * rod_theta_ddot + (w3 * c12 - w7 * w4) * rod_q1_ddot - w7 * w5 * rod_q2_ddot
    w19 = c14 * rod_q1 - (c15 * rod_q1 + c16 * rod_q2)
    w20 = c17 * rod_q2 - (c18 * rod_q1 + c19 * rod_q2)
    w21 = w9 * rod_y_ddot - w14 * rod_x_ddot + (c20 + (rod_q1 * w19 + rod_q2 * w20)) * rod_theta_ddot + c21 * rod_q1_ddot
    w22 = -2.0 * (w19 * rod_q1_dot + w20 * rod_q2_dot) * rod_theta_dot + w9 * c24 - (w21 + c22 * rod_q2_ddot)
    w23 = c6 - (rod_q1 * (c4 * rod_q1) + rod_q2 * (c5 * rod_q2)) / 2.0
    w24 = (w22 + w7 * w23 * w16) / (w3 * w23)
    w25 = w14 * w10 + w7 * w13 - 2 * -(w3 * w12 + w7 * w11) * rod_theta_dot + c26 - w18 - w24
    lam = ca.vertcat(
        w0 * w1 - (c32 * crank_x_ddot - w2 * crank_theta_ddot) + w17,
        w2 * w1 + c31 - (c32 * crank_y_ddot + w0 * crank_theta_ddot) + w25,
        w17,
        w25,
        c34 - c13 * slider_y_ddot + w24,
        -(c33 * slider_theta_ddot),
        -w16,
        -w24,
    )
    lam = ca.densify(lam)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 197 operations."""
    q = ca.SX.sym("q", 11)
    q_dot = ca.SX.sym("q_dot", 11)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 141)
    crank_y = q[1]
    crank_theta = q[2]
    rod_y = q[4]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    slider_y = q[9]
    crank_x_dot = q_dot[0]
    crank_y_dot = q_dot[1]
    crank_theta_dot = q_dot[2]
    rod_x_dot = q_dot[3]
    rod_y_dot = q_dot[4]
    rod_theta_dot = q_dot[5]
    rod_q1_dot = q_dot[6]
    rod_q2_dot = q_dot[7]
    slider_x_dot = q_dot[8]
    slider_y_dot = q_dot[9]
    slider_theta_dot = q_dot[10]
    c1 = c[1]
    c2 = c[2]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
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
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    c32 = c[32]
    c33 = c[33]
    w0 = ca.sin(crank_theta) * c23
    w1 = ca.cos(crank_theta) * c23
    w2 = crank_x_dot * (c32 * crank_x_dot - w0 * crank_theta_dot) + crank_y_dot * (c32 * crank_y_dot + w1 * crank_theta_dot)
    w3 = ca.sin(rod_theta)
    w4 = c7 * rod_q1 + c8 * rod_q2
    w5 = c9 * rod_q1 + c10 * rod_q2
    w6 = c11 - (rod_q1 * w4 + rod_q2 * w5) / 2.0
    w7 = ca.cos(rod_theta)
    w8 = c12 * rod_q1
    w9 = w3 * w6 + w7 * w8
    w10 = w7 * w4 + w3 * c12
    w11 = w7 * w5
    w12 = w2 + crank_theta_dot * (w1 * crank_y_dot - w0 * crank_x_dot + c2 * crank_theta_dot) + rod_x_dot * (c1 * rod_x_dot - w9 * rod_theta_dot - w10 * rod_q1_dot - w11 * rod_q2_dot)
    w13 = w7 * w6 - w3 * w8
    w14 = w7 * c12 - w3 * w4
    w15 = w3 * w5
    w16 = rod_q1 * (c14 * rod_q1 - (c15 * rod_q1 + c16 * rod_q2)) + rod_q2 * (c17 * rod_q2 - (c18 * rod_q1 + c19 * rod_q2))
    w17 = w13 * rod_y_dot - w9 * rod_x_dot + (c20 + w16) * rod_theta_dot + c21 * rod_q1_dot + c22 * rod_q2_dot
    w18 = w12 + rod_y_dot * (c1 * rod_y_dot + w13 * rod_theta_dot + w14 * rod_q1_dot - w15 * rod_q2_dot) + rod_theta_dot * w17
    w19 = w18 + rod_q1_dot * (w14 * rod_y_dot - w10 * rod_x_dot + c21 * rod_theta_dot + c14 * rod_q1_dot) + rod_q2_dot * (c22 * rod_theta_dot - (w11 * rod_x_dot + w15 * rod_y_dot) + c17 * rod_q2_dot)
    w20 = w19 + slider_x_dot * (c13 * slider_x_dot) + slider_y_dot * (c13 * slider_y_dot) + slider_theta_dot * (c33 * slider_theta_dot)
    kinetic = ca.vertcat(
        w20 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        (rod_q1 * c27 * rod_q1 + rod_q2 * c29 * rod_q2) / 2.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        -(c24 * (c32 * crank_y + w0) + c24 * (c1 * rod_y + w9) + c24 * (c13 * slider_y)),
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        rod_q1_dot * c28 * rod_q1_dot + rod_q2_dot * c30 * rod_q2_dot,
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        ca.if_else(t < 0.15, c25 * crank_theta_dot, 0),
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, t, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "t", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def drawing() -> ca.Function:
    """World points of the polylines that show the bodies. 509 operations."""
    q = ca.SX.sym("q", 11)
    exaggeration = ca.SX.sym("exaggeration", 1)
    c = ca.SX.sym("c", 141)
    crank_x = q[0]
    crank_y = q[1]
    crank_theta = q[2]
    rod_x = q[3]
    rod_y = q[4]
    rod_theta = q[5]
    rod_q1 = q[6]
    rod_q2 = q[7]
    slider_x = q[8]
    slider_y = q[9]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
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
    c85 = c[85]
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
    c111 = c[111]
    c112 = c[112]
    c113 = c[113]
    c114 = c[114]
    c115 = c[115]
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
    w0 = ca.cos(rod_theta)
    w1 = rod_q1 * exaggeration
    w2 = rod_q2 * exaggeration
    w3 = c39 - (w1 * (c35 * w1 + c36 * w2) + w2 * (c37 * w1 + c38 * w2)) / 2.0
    w4 = ca.sin(rod_theta)
    w5 = c40 * w1 + c41 * w2
    w6 = c46 - (w1 * (c42 * w1 + c43 * w2) + w2 * (c44 * w1 + c45 * w2)) / 2.0
    w7 = c47 * w1 + c48 * w2
    w8 = c53 - (w1 * (c49 * w1 + c50 * w2) + w2 * (c51 * w1 + c52 * w2)) / 2.0
    w9 = c54 * w1 + c55 * w2
    w10 = c60 - (w1 * (c56 * w1 + c57 * w2) + w2 * (c58 * w1 + c59 * w2)) / 2.0
    w11 = c61 * w1 + c62 * w2
    w12 = c67 - (w1 * (c63 * w1 + c64 * w2) + w2 * (c65 * w1 + c66 * w2)) / 2.0
    w13 = c68 * w1 + c69 * w2
    w14 = c74 - (w1 * (c70 * w1 + c71 * w2) + w2 * (c72 * w1 + c73 * w2)) / 2.0
    w15 = c75 * w1 + c76 * w2
    w16 = c81 - (w1 * (c77 * w1 + c78 * w2) + w2 * (c79 * w1 + c80 * w2)) / 2.0
    w17 = c82 * w1 + c83 * w2
    w18 = c88 - (w1 * (c84 * w1 + c85 * w2) + w2 * (c86 * w1 + c87 * w2)) / 2.0
    w19 = c89 * w1
    w20 = c94 - (w1 * (c90 * w1 + c91 * w2) + w2 * (c92 * w1 + c93 * w2)) / 2.0
    w21 = c95 * w1 + c96 * w2
    w22 = c101 - (w1 * (c97 * w1 + c98 * w2) + w2 * (c99 * w1 + c100 * w2)) / 2.0
    w23 = c102 * w1 + c103 * w2
    w24 = c108 - (w1 * (c104 * w1 + c105 * w2) + w2 * (c106 * w1 + c107 * w2)) / 2.0
    w25 = c109 * w1 + c110 * w2
    w26 = c115 - (w1 * (c111 * w1 + c112 * w2) + w2 * (c113 * w1 + c114 * w2)) / 2.0
    w27 = c116 * w1 + c117 * w2
    w28 = c122 - (w1 * (c118 * w1 + c119 * w2) + w2 * (c120 * w1 + c121 * w2)) / 2.0
    w29 = c123 * w1 + c124 * w2
    w30 = c129 - (w1 * (c125 * w1 + c126 * w2) + w2 * (c127 * w1 + c128 * w2)) / 2.0
    w31 = c130 * w1 + c131 * w2
    w32 = c136 - (w1 * (c132 * w1 + c133 * w2) + w2 * (c134 * w1 + c135 * w2)) / 2.0
    w33 = c137 * w1 + c138 * w2
    w34 = c6 - (w1 * (c4 * w1) + w2 * (c5 * w2)) / 2.0
    xy = ca.vertcat(
        crank_x,
        crank_y,
        crank_x + ca.cos(crank_theta) * c0,
        crank_y + ca.sin(crank_theta) * c0,
        rod_x,
        rod_y,
        rod_x + (w0 * w3 - w4 * w5),
        rod_y + (w4 * w3 + w0 * w5),
        rod_x + (w0 * w6 - w4 * w7),
        rod_y + (w4 * w6 + w0 * w7),
        rod_x + (w0 * w8 - w4 * w9),
        rod_y + (w4 * w8 + w0 * w9),
        rod_x + (w0 * w10 - w4 * w11),
        rod_y + (w4 * w10 + w0 * w11),
        rod_x + (w0 * w12 - w4 * w13),
        rod_y + (w4 * w12 + w0 * w13),
        rod_x + (w0 * w14 - w4 * w15),
        rod_y + (w4 * w14 + w0 * w15),
        rod_x + (w0 * w16 - w4 * w17),
        rod_y + (w4 * w16 + w0 * w17),
        rod_x + (w0 * w18 - w4 * w19),
        rod_y + (w4 * w18 + w0 * w19),
        rod_x + (w0 * w20 - w4 * w21),
        rod_y + (w4 * w20 + w0 * w21),
        rod_x + (w0 * w22 - w4 * w23),
        rod_y + (w4 * w22 + w0 * w23),
        rod_x + (w0 * w24 - w4 * w25),
        rod_y + (w4 * w24 + w0 * w25),
        rod_x + (w0 * w26 - w4 * w27),
        rod_y + (w4 * w26 + w0 * w27),
        rod_x + (w0 * w28 - w4 * w29),
        rod_y + (w4 * w28 + w0 * w29),
        rod_x + (w0 * w30 - w4 * w31),
        rod_y + (w4 * w30 + w0 * w31),
        rod_x + (w0 * w32 - w4 * w33),
        rod_y + (w4 * w32 + w0 * w33),
        rod_x + w0 * w34,
        rod_y + w4 * w34,
        slider_x,
        slider_y,
    )
    xy = ca.reshape(xy, 2, 20)
    xy = ca.densify(xy)
    inputs, outputs = [q, exaggeration, c], [xy]
    return ca.Function("drawing", inputs, outputs, ["q", "exaggeration", "c"], ["xy"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 739 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 141)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    c0 = c[0]
    c1 = c[1]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
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
    c26 = c[26]
    c27 = c[27]
    c29 = c[29]
    c139 = c[139]
    c140 = c[140]
    w0 = ca.cos(crank_theta)
    w1 = w0 * c0
    w2 = crank_theta_dot**2
    w3 = c0 * w0
    w4 = w2 * w3
    w5 = ca.cos(rod_theta)
    w6 = c7 * rod_q1 + c8 * rod_q2
    w7 = c9 * rod_q1 + c10 * rod_q2
    w8 = c11 - (rod_q1 * w6 + rod_q2 * w7) / 2.0
    w9 = ca.sin(rod_theta)
    w10 = c12 * rod_q1
    w11 = w5 * w8 - w9 * w10
    w12 = c4 * rod_q1
    w13 = c5 * rod_q2
    w14 = c6 - (rod_q1 * w12 + rod_q2 * w13) / 2.0
    w15 = w5 * w14
    w16 = w4 / w15
    w17 = w9 * w8 + w5 * w10
    w18 = rod_theta_dot**2
    w19 = rod_q1_dot * (c7 * rod_q1_dot + c8 * rod_q2_dot) + rod_q2_dot * (c9 * rod_q1_dot + c10 * rod_q2_dot)
    w20 = w6 * rod_q1_dot + w7 * rod_q2_dot
    w21 = c12 * rod_q1_dot
    w22 = 2 * -(w5 * w20 + w9 * w21)
    w23 = ca.sin(crank_theta)
    w24 = w23 * c0
    w25 = w24 * w2
    w26 = w12 * rod_q1_dot + w13 * rod_q2_dot
    w27 = 2 * -(w5 * w26)
    w28 = rod_q1_dot * (c4 * rod_q1_dot) + rod_q2_dot * (c5 * rod_q2_dot)
    w29 = w9 * w14
    w30 = w27 * rod_theta_dot - w9 * w28 - w29 * w18 - w25
    w31 = w30 / w15
    w32 = c0 * w23
    w33 = w1 * (c1 * w4 - w11 * w16) - (w17 * w18 + w9 * w19 - w22 * rod_theta_dot + c26 + (c1 * w25 + w11 * w31)) * w32
    w34 = 2 * (w5 * w21 - w9 * w20)
    w35 = w1 * w2
    w36 = 2 * -(w9 * w26)
    w37 = c13 * (w29 * w31 - (w5 * w28 + w15 * w18 + w36 * rod_theta_dot + w35))
    w38 = w2 * w32
    w39 = c13 * (w38 - w29 * w16)
    w40 = (w11 * w18 + w34 * rod_theta_dot + w5 * w19 - (w17 * w31 - c1 * w35) - w37) * w3 - w24 * (c1 * w38 - w17 * w16 + w39)
    w41 = w1 / w15
    w42 = c14 * rod_q1 - (c15 * rod_q1 + c16 * rod_q2)
    w43 = c17 * rod_q2 - (c18 * rod_q1 + c19 * rod_q2)
    w44 = c20 + (rod_q1 * w42 + rod_q2 * w43)
    w45 = w29 * w39 - (w44 * w16 - (w17 * w38 + w11 * w4))
    w46 = -2.0 * (w42 * rod_q1_dot + w43 * rod_q2_dot)
    w47 = w46 * rod_theta_dot + w11 * c24 - (w17 * w35 - w11 * w25 - w44 * w31) + w37 * w29
    w48 = w32 / w15
    w49 = w8 * w5 - w10 * w9
    w50 = w14 * w5
    w51 = w31 / w15
    w52 = w14 * w9
    w53 = (rod_theta_dot * (2 * (w26 * w9)) - w28 * w5 - w18 * w50) / w15 + w51 * w52
    w54 = w8 * w9 + w10 * w5
    w55 = w1 * (w18 * w49 + w19 * w5 - rod_theta_dot * (2 * -(w21 * w5 - w20 * w9)) + (w11 * w53 - w31 * w54))
    w56 = c13 * (w30 + w29 * w53 - (rod_theta_dot * (2 * -(w26 * w5)) - (w28 * w9 + w18 * w52)))
    w57 = rod_theta_dot * (2 * -(w21 * w9 + w20 * w5)) - w18 * w54 - w19 * w9 - (w31 * w49 + w17 * w53) - w56
    w58 = w29 * w56 + w37 * w50 - (c24 * w54 + (w35 * w49 + w25 * w54 - w44 * w53))
    w59 = w41 / w15
    w60 = w59 * w52
    w61 = w55 - w24 * w57 - (w41 * w58 + w47 * w60)
    w62 = 2 * rod_theta_dot
    w63 = (w27 - w29 * w62) / w15
    w64 = c13 * (w29 * w63 - (w15 * w62 + w36))
    w65 = w46 + w44 * w63 + w29 * w64
    w66 = w1 * (w17 * w62 - w22 + w11 * w63) - w24 * (w11 * w62 + w34 - w17 * w63 - w64) - w41 * w65
    w67 = w9 * w12
    w68 = w67 / w15
    w69 = w68 / w15
    w70 = w12 * w5 / w15 + w69 * w52
    w71 = w9 * w13
    w72 = w71 / w15
    w73 = w72 / w15
    w74 = w13 * w5 / w15 + w73 * w52
    w75 = rod_q1_dot * w70 - crank_theta_dot * w60 + rod_q2_dot * w74
    w76 = crank_theta_dot * w48 - w75 * w41
    w77 = w5 * w12
    w78 = w9 * c12
    w79 = w5 * c12
    w80 = c12 * w9 + w6 * w5
    w81 = w77 * w56 - w37 * (w12 * w9) - (c24 * w80 + (w35 * (c12 * w5 - w6 * w9) + w25 * w80 - c21 * w53))
    w82 = w81 + (w68 * w58 + w47 * w70)
    w83 = w42 * w62 + c21 * w63 + w77 * w64 + w68 * w65
    w84 = w77 * w39 - (c21 * w16 - ((w5 * w6 + w78) * w38 + (w79 - w9 * w6) * w4)) + w68 * w45 - w82 * w41 + w83 * w76
    w85 = w5 * w13
    w86 = w7 * w5
    w87 = w85 * w56 - w37 * (w13 * w9) - (c24 * w86 + (w25 * w86 - w35 * (w7 * w9) - c22 * w53)) + (w72 * w58 + w47 * w74)
    w88 = w43 * w62 + c22 * w63 + w85 * w64 + w72 * w65
    w89 = 0.5 * (w6 + rod_q1 * c7 + rod_q2 * c9)
    w90 = w79 - w9 * w89
    w91 = rod_q1_dot * c7 + rod_q2_dot * c9
    w92 = rod_q1_dot * c4
    w93 = (rod_theta_dot * (2 * -(w5 * w92)) + w18 * w67) / w15 + w51 * w77
    w94 = w5 * w89 + w78
    w95 = c13 * (w29 * w93 - w31 * w67 - (rod_theta_dot * (2 * -(w9 * w92)) - w18 * w77))
    w96 = w1 * (w18 * w90 - rod_theta_dot * (2 * -(w5 * w91)) + (w11 * w93 - w31 * w94)) - w24 * (rod_theta_dot * (2 * -(w9 * w91)) - w18 * w94 - (w31 * w90 + w17 * w93) - w95)
    w97 = rod_theta_dot * (-2.0 * (rod_q1_dot * c139 - rod_q2_dot * c18)) - c24 * w94 - (w35 * w90 + w25 * w94 - (w31 * (w42 + rod_q1 * c139 - rod_q2 * c18) + w44 * w93))
    w98 = w97 + (w29 * w95 - w37 * w67)
    w99 = w59 * w77
    w100 = w9 * c4 / w15 + w69 * w77
    w101 = w73 * w77
    w102 = rod_q1_dot * w100 - crank_theta_dot * w99 + rod_q2_dot * w101 + w75 * w68
    w103 = w9 * c7
    w104 = w18 * c139 - c27 - c24 * w103 - (w35 * (w5 * c7) + w25 * w103 - c21 * w93) + (w77 * w95 + w37 * (w5 * c4))
    w105 = w9 * c9
    w106 = w85 * w95 - (w18 * c18 + c24 * w105 + (w35 * (w5 * c9) + w25 * w105 - c22 * w93)) + (w72 * w98 + w47 * w101)
    w107 = rod_q2_dot * c5
    w108 = (rod_theta_dot * (2 * -(w5 * w107)) + w18 * w71) / w15 + w51 * w85
    w109 = 0.5 * (rod_q1 * c8 + (w7 + rod_q2 * c10))
    w110 = w5 * w109
    w111 = w9 * w109
    w112 = rod_q1_dot * c8 + rod_q2_dot * c10
    w113 = c13 * (w29 * w108 - w31 * w71 - (rod_theta_dot * (2 * -(w9 * w107)) - w18 * w85))
    w114 = w1 * (w11 * w108 - w31 * w110 - (w18 * w111 + rod_theta_dot * (2 * -(w5 * w112)))) - w24 * (rod_theta_dot * (2 * -(w9 * w112)) - w18 * w110 - (w17 * w108 - w31 * w111) - w113)
    w115 = rod_theta_dot * (-2.0 * (rod_q2_dot * c140 - rod_q1_dot * c16)) - c24 * w110 - (w25 * w110 - w35 * w111 - (w31 * (w43 + rod_q2 * c140 - rod_q1 * c16) + w44 * w108))
    w116 = w115 + (w29 * w113 - w37 * w71)
    w117 = w59 * w85
    w118 = w69 * w85
    w119 = w9 * c5 / w15 + w73 * w85
    w120 = rod_q1_dot * w118 - crank_theta_dot * w117 + rod_q2_dot * w119 + w75 * w72
    w121 = w9 * c8
    w122 = w77 * w113 - (w18 * c16 + c24 * w121 + (w35 * (w5 * c8) + w25 * w121 - c21 * w108)) + (w68 * w116 + w47 * w118)
    w123 = w9 * c10
    w124 = w18 * c140 - c29 - c24 * w123 - (w35 * (w5 * c10) + w25 * w123 - c22 * w108) + (w85 * w113 + w37 * (w5 * c5))
    dQ_hat_dq_i = ca.vertcat(
        w33 - c24 * (c23 * w23) - w40 - (w41 * w45 - w47 * w48) - w61 * w41 + w66 * w76,
        w84,
        w85 * w39 - (w9 * w7 * w4 - w5 * w7 * w38 + c22 * w16) + w72 * w45 - w87 * w41 + w88 * w76,
        w96 - (w41 * w98 + w47 * w99) + w61 * w68 + w66 * w102,
        w104 + (w68 * w98 + w47 * w100) + w82 * w68 + w83 * w102,
        w106 + w87 * w68 + w88 * w102,
        w114 - (w41 * w116 + w47 * w117) + w61 * w72 + w66 * w120,
        w122 + w82 * w72 + w83 * w120,
        w124 + (w72 * w116 + w47 * w119) + w87 * w72 + w88 * w120,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 3, 3)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 354 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    c = ca.SX.sym("c", 141)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    c0 = c[0]
    c1 = c[1]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
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
    c28 = c[28]
    c30 = c[30]
    w0 = ca.cos(crank_theta) * c0
    w1 = ca.sin(crank_theta) * c0
    w2 = 2 * crank_theta_dot
    w3 = w1 * w2
    w4 = ca.cos(rod_theta)
    w5 = c7 * rod_q1 + c8 * rod_q2
    w6 = c9 * rod_q1 + c10 * rod_q2
    w7 = c11 - (rod_q1 * w5 + rod_q2 * w6) / 2.0
    w8 = ca.sin(rod_theta)
    w9 = c12 * rod_q1
    w10 = w4 * w7 - w8 * w9
    w11 = c4 * rod_q1
    w12 = c5 * rod_q2
    w13 = c6 - (rod_q1 * w11 + rod_q2 * w12) / 2.0
    w14 = w4 * w13
    w15 = w3 / w14
    w16 = w8 * w7 + w4 * w9
    w17 = w0 * w2
    w18 = w8 * w13
    w19 = c13 * (w18 * w15 + w17)
    w20 = w0 / w14
    w21 = c14 * rod_q1 - (c15 * rod_q1 + c16 * rod_q2)
    w22 = c17 * rod_q2 - (c18 * rod_q1 + c19 * rod_q2)
    w23 = c20 + (rod_q1 * w21 + rod_q2 * w22)
    w24 = w16 * w17 - w10 * w3 + w23 * w15 + w18 * w19
    w25 = 2 * rod_theta_dot
    w26 = w5 * rod_q1_dot + w6 * rod_q2_dot
    w27 = c12 * rod_q1_dot
    w28 = w11 * rod_q1_dot + w12 * rod_q2_dot
    w29 = (2 * -(w4 * w28) - w18 * w25) / w14
    w30 = c13 * (w18 * w29 - (w14 * w25 + 2 * -(w8 * w28)))
    w31 = w0 * (w16 * w25 - 2 * -(w4 * w26 + w8 * w27) + w10 * w29) - w1 * (w10 * w25 + 2 * (w4 * w27 - w8 * w26) - w16 * w29 - w30)
    w32 = -2.0 * (w21 * rod_q1_dot + w22 * rod_q2_dot) + w23 * w29 + w18 * w30
    w33 = w31 - w20 * w32
    w34 = w4 * w5 + w8 * c12
    w35 = w4 * c12 - w8 * w5
    w36 = w4 * w11
    w37 = w8 * w11
    w38 = w37 / w14
    w39 = w21 * w25 + c21 * w29 + w36 * w30 + w38 * w32
    w40 = w4 * w6
    w41 = w8 * w6
    w42 = w4 * w12
    w43 = w8 * w12
    w44 = w43 / w14
    w45 = w22 * w25 + c22 * w29 + w42 * w30 + w44 * w32
    w46 = c7 * rod_q1_dot + c8 * rod_q2_dot + rod_q1_dot * c7 + rod_q2_dot * c9
    w47 = 2 * (c4 * rod_q1_dot)
    w48 = (rod_theta_dot * (2 * -w36) - w8 * w47) / w14
    w49 = c13 * (w18 * w48 - (w4 * w47 + rod_theta_dot * (2 * -w37)))
    w50 = w0 * (w8 * w46 - rod_theta_dot * (2 * -w34) + w10 * w48) - w1 * (rod_theta_dot * (2 * w35) + w4 * w46 - w16 * w48 - w49)
    w51 = rod_theta_dot * (-2.0 * w21) + w23 * w48 + w18 * w49
    w52 = rod_q1_dot * c8 + (c9 * rod_q1_dot + c10 * rod_q2_dot + rod_q2_dot * c10)
    w53 = 2 * (c5 * rod_q2_dot)
    w54 = (rod_theta_dot * (2 * -w42) - w8 * w53) / w14
    w55 = c13 * (w18 * w54 - (w4 * w53 + rod_theta_dot * (2 * -w43)))
    w56 = w0 * (w8 * w52 - rod_theta_dot * (2 * -w40) + w10 * w54) - w1 * (rod_theta_dot * (2 * -w41) + w4 * w52 - w16 * w54 - w55)
    w57 = rod_theta_dot * (-2.0 * w22) + w23 * w54 + w18 * w55
    dQ_hat_dq_i_dot = ca.vertcat(
        w0 * (c1 * w3 - w10 * w15) - w1 * (w16 * w15 + c1 * w17 + w19) + w20 * w24 - w33 * w20,
        -(w34 * w17 - w35 * w3 + c21 * w15 + w36 * w19 + w38 * w24 + w39 * w20),
        -(w40 * w17 + w41 * w3 + c22 * w15 + w42 * w19 + w44 * w24 + w45 * w20),
        w50 - w20 * w51 + w33 * w38,
        c21 * w48 - c28 + w36 * w49 + w38 * w51 + w39 * w38,
        c22 * w48 + w42 * w49 + w44 * w51 + w45 * w38,
        w56 - w20 * w57 + w33 * w44,
        c21 * w54 + w36 * w55 + w38 * w57 + w39 * w44,
        c22 * w54 - c30 + w42 * w55 + w44 * w57 + w45 * w44,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 3, 3)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 495 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_ddot = ca.SX.sym("q_i_ddot", 3)
    c = ca.SX.sym("c", 141)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_ddot = q_i_ddot[0]
    rod_q1_ddot = q_i_ddot[1]
    rod_q2_ddot = q_i_ddot[2]
    c0 = c[0]
    c1 = c[1]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
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
    c139 = c[139]
    c140 = c[140]
    w0 = ca.cos(crank_theta)
    w1 = w0 * c0
    w2 = ca.cos(rod_theta)
    w3 = c7 * rod_q1 + c8 * rod_q2
    w4 = c9 * rod_q1 + c10 * rod_q2
    w5 = c11 - (rod_q1 * w3 + rod_q2 * w4) / 2.0
    w6 = ca.sin(rod_theta)
    w7 = c12 * rod_q1
    w8 = w2 * w5 - w6 * w7
    w9 = ca.sin(crank_theta)
    w10 = c0 * w9
    w11 = c4 * rod_q1
    w12 = c5 * rod_q2
    w13 = c6 - (rod_q1 * w11 + rod_q2 * w12) / 2.0
    w14 = w2 * w13
    w15 = w10 / w14
    w16 = crank_theta_ddot * w15
    w17 = crank_theta_ddot * w10
    w18 = w1 * crank_theta_ddot
    w19 = w6 * w11
    w20 = w19 / w14
    w21 = w1 / w14
    w22 = w6 * w12
    w23 = w22 / w14
    w24 = w20 * rod_q1_ddot - w21 * crank_theta_ddot + w23 * rod_q2_ddot
    w25 = w2 * c12
    w26 = w25 - w6 * w3
    w27 = w6 * w4
    w28 = w9 * c0
    w29 = c0 * w0
    w30 = crank_theta_ddot * w29
    w31 = w6 * w5 + w2 * w7
    w32 = w6 * w13
    w33 = c13 * (w30 + w32 * w16)
    w34 = w28 * crank_theta_ddot
    w35 = w6 * c12
    w36 = w2 * w3 + w35
    w37 = w2 * w4
    w38 = w2 * w11
    w39 = w2 * w12
    w40 = c13 * (w34 + w32 * w24 + w38 * rod_q1_ddot + w39 * rod_q2_ddot)
    w41 = w28 * (c1 * w30 + w31 * w16 + w33) + (c1 * w34 + w31 * w24 + w36 * rod_q1_ddot + w37 * rod_q2_ddot + w40) * w29
    w42 = w1 * (w8 * w16 - c1 * w17) - (c1 * w18 + w8 * w24 + w26 * rod_q1_ddot - w27 * rod_q2_ddot) * w10 + w41
    w43 = c14 * rod_q1 - (c15 * rod_q1 + c16 * rod_q2)
    w44 = c17 * rod_q2 - (c18 * rod_q1 + c19 * rod_q2)
    w45 = c20 + (rod_q1 * w43 + rod_q2 * w44)
    w46 = w31 * w30 - w8 * w17 + w45 * w16 + w32 * w33
    w47 = w31 * w34 + w8 * w18 + w45 * w24 + c21 * rod_q1_ddot + c22 * rod_q2_ddot + w40 * w32
    w48 = w20 / w14
    w49 = w13 * w6
    w50 = w11 * w2 / w14 + w48 * w49
    w51 = w21 / w14
    w52 = w51 * w49
    w53 = w23 / w14
    w54 = w12 * w2 / w14 + w53 * w49
    w55 = rod_q1_ddot * w50 - crank_theta_ddot * w52 + rod_q2_ddot * w54
    w56 = w5 * w6 + w7 * w2
    w57 = c12 * w6 + w3 * w2
    w58 = w4 * w2
    w59 = w5 * w2 - w7 * w6
    w60 = c12 * w2 - w3 * w6
    w61 = w4 * w6
    w62 = w13 * w2
    w63 = w11 * w6
    w64 = w12 * w6
    w65 = c13 * (w24 * w62 + w32 * w55 - rod_q1_ddot * w63 - rod_q2_ddot * w64)
    w66 = w1 * (w8 * w55 - w24 * w56 - rod_q1_ddot * w57 - rod_q2_ddot * w58) + w28 * (w24 * w59 + w31 * w55 + rod_q1_ddot * w60 - rod_q2_ddot * w61 + w65)
    w67 = w34 * w59 - w18 * w56 + w45 * w55 + (w32 * w65 + w40 * w62)
    w68 = w66 - (w21 * w67 + w47 * w52)
    w69 = w34 * w60 - w18 * w57 + c21 * w55 + (w38 * w65 - w40 * w63) + (w20 * w67 + w47 * w50)
    w70 = c22 * w55 - (w34 * w61 + w18 * w58) + (w39 * w65 - w40 * w64) + (w23 * w67 + w47 * w54)
    w71 = w6 * c4 / w14 + w48 * w38
    w72 = w51 * w38
    w73 = w53 * w38
    w74 = rod_q1_ddot * w71 - crank_theta_ddot * w72 + rod_q2_ddot * w73
    w75 = 0.5 * (w3 + rod_q1 * c7 + rod_q2 * c9)
    w76 = w2 * w75 + w35
    w77 = w6 * c7
    w78 = w6 * c9
    w79 = w25 - w6 * w75
    w80 = w2 * c7
    w81 = w2 * c9
    w82 = w2 * c4
    w83 = c13 * (w32 * w74 - w24 * w19 + rod_q1_ddot * w82)
    w84 = w1 * (w8 * w74 - w24 * w76 - rod_q1_ddot * w77 - rod_q2_ddot * w78) + w28 * (w24 * w79 + w31 * w74 + rod_q1_ddot * w80 + rod_q2_ddot * w81 + w83)
    w85 = w34 * w79 - w18 * w76 + (w24 * (w43 + rod_q1 * c139 - rod_q2 * c18) + w45 * w74) + (w32 * w83 - w40 * w19)
    w86 = w34 * w80 - w18 * w77 + c21 * w74 + (w38 * w83 + w40 * w82) + (w20 * w85 + w47 * w71) + w69 * w20
    w87 = w48 * w39
    w88 = w51 * w39
    w89 = w6 * c5 / w14 + w53 * w39
    w90 = rod_q1_ddot * w87 - crank_theta_ddot * w88 + rod_q2_ddot * w89
    w91 = 0.5 * (rod_q1 * c8 + (w4 + rod_q2 * c10))
    w92 = w2 * w91
    w93 = w6 * c8
    w94 = w6 * c10
    w95 = w6 * w91
    w96 = w2 * c8
    w97 = w2 * c10
    w98 = w2 * c5
    w99 = c13 * (w32 * w90 - w24 * w22 + rod_q2_ddot * w98)
    w100 = w1 * (w8 * w90 - w24 * w92 - rod_q1_ddot * w93 - rod_q2_ddot * w94) + w28 * (w31 * w90 - w24 * w95 + rod_q1_ddot * w96 + rod_q2_ddot * w97 + w99)
    w101 = w24 * (w44 + rod_q2 * c140 - rod_q1 * c16) + w45 * w90 - (w34 * w95 + w18 * w92) + (w32 * w99 - w40 * w22)
    w102 = w34 * w97 - w18 * w94 + c22 * w90 + (w39 * w99 + w40 * w98) + (w23 * w101 + w47 * w89) + w70 * w23
    dMa_dq_i = ca.vertcat(
        w42 - (w21 * w46 - w47 * w15) - w68 * w21,
        w36 * w30 - w26 * w17 + c21 * w16 + w38 * w33 + w20 * w46 - w69 * w21,
        w37 * w30 + w27 * w17 + c22 * w16 + w39 * w33 + w23 * w46 - w70 * w21,
        w84 - (w21 * w85 + w47 * w72) + w68 * w20,
        w86,
        w34 * w81 - w18 * w78 + c22 * w74 + w39 * w83 + (w23 * w85 + w47 * w73) + w70 * w20,
        w100 - (w21 * w101 + w47 * w88) + w68 * w23,
        w34 * w96 - w18 * w93 + c21 * w90 + w38 * w99 + (w20 * w101 + w47 * w87) + w69 * w23,
        w102,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 3, 3)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_d, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_d", "q_i_ddot", "c"], ["dMa_dq_i"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64). 223 operations."""
    q_i = ca.SX.sym("q_i", 3)
    q_d = ca.SX.sym("q_d", 8)
    q_i_dot = ca.SX.sym("q_i_dot", 3)
    q_d_dot = ca.SX.sym("q_d_dot", 8)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 141)
    crank_theta = q_i[0]
    rod_q1 = q_i[1]
    rod_q2 = q_i[2]
    rod_theta = q_d[4]
    crank_theta_dot = q_i_dot[0]
    rod_q1_dot = q_i_dot[1]
    rod_q2_dot = q_i_dot[2]
    rod_theta_dot = q_d_dot[4]
    crank_theta_ddot = q_L_ddot[0]
    c0 = c[0]
    c4 = c[4]
    c5 = c[5]
    c6 = c[6]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c11 = c[11]
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
    c24 = c[24]
    c27 = c[27]
    c28 = c[28]
    c29 = c[29]
    c30 = c[30]
    w0 = ca.cos(rod_theta)
    w1 = c4 * rod_q1
    w2 = w0 * w1
    w3 = w2 * c13
    w4 = ca.sin(rod_theta)
    w5 = c5 * rod_q2
    w6 = c6 - (rod_q1 * w1 + rod_q2 * w5) / 2.0
    w7 = w0 * w6
    w8 = w4 * w1 / w7
    w9 = w4 * w6
    w10 = c21 + w9 * w3
    w11 = c14 * rod_q1 - (c15 * rod_q1 + c16 * rod_q2)
    w12 = c17 * rod_q2 - (c18 * rod_q1 + c19 * rod_q2)
    w13 = c20 + (rod_q1 * w11 + rod_q2 * w12)
    w14 = w13 + w9 * (w9 * c13)
    w15 = w0 * w5
    w16 = w15 * c13
    w17 = c22 + w9 * w16
    w18 = w4 * w5 / w7
    w19 = w17 + w18 * w14
    w20 = w2 * w16 + (w8 * w19 + w18 * w10)
    w21 = rod_theta_dot**2
    w22 = c7 * rod_q1 + c8 * rod_q2
    w23 = w0 * c12 - w4 * w22
    w24 = ca.cos(crank_theta) * c0
    w25 = crank_theta_dot**2
    w26 = ca.sin(crank_theta) * c0
    w27 = w24 * w25 + w26 * crank_theta_ddot
    w28 = w26 * w25
    w29 = w24 * crank_theta_ddot - w28
    w30 = w1 * rod_q1_dot + w5 * rod_q2_dot
    w31 = rod_q1_dot * (c4 * rod_q1_dot) + rod_q2_dot * (c5 * rod_q2_dot)
    w32 = (2 * -(w0 * w30) * rod_theta_dot - w4 * w31 - w9 * w21 - w28) / w7 + w24 / w7 * crank_theta_ddot
    w33 = w11 * w21 - (c27 * rod_q1 + c28 * rod_q1_dot) + w23 * c24 - ((w0 * w22 + w4 * c12) * w27 + w23 * w29 - c21 * w32)
    w34 = c13 * (w9 * w32 - (w0 * w31 + w7 * w21 + 2 * -(w4 * w30) * rod_theta_dot + w27))
    w35 = c9 * rod_q1 + c10 * rod_q2
    w36 = c11 - (rod_q1 * w22 + rod_q2 * w35) / 2.0
    w37 = c12 * rod_q1
    w38 = w0 * w36 - w4 * w37
    w39 = -2.0 * (w11 * rod_q1_dot + w12 * rod_q2_dot) * rod_theta_dot + w38 * c24 - ((w4 * w36 + w0 * w37) * w27 + w38 * w29 - w13 * w32)
    w40 = w39 + w34 * w9
    w41 = w4 * w35
    w42 = w12 * w21 - (c29 * rod_q2 + c30 * rod_q2_dot) - w41 * c24 - (w0 * w35 * w27 - w41 * w29 - c22 * w32)
    M_hat_SS = ca.vertcat(
        c14 + w2 * w3 + (w8 * (w10 + w8 * w14) + w8 * w10),
        w20,
        w20,
        c17 + w15 * w16 + (w18 * w19 + w18 * w17),
    )
    M_hat_SS = ca.reshape(M_hat_SS, 2, 2)
    M_hat_SS = ca.densify(M_hat_SS)
    rhs_S = ca.vertcat(
        w33 + w34 * w2 + w40 * w8,
        w42 + w34 * w15 + w40 * w18,
    )
    rhs_S = ca.densify(rhs_S)
    inputs, outputs = [q_i, q_d, q_i_dot, q_d_dot, q_L_ddot, c], [M_hat_SS, rhs_S]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d", "q_i_dot", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


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
    "drawing": drawing,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "dMa_dq_i": dMa_dq_i,
    "substep_2": substep_2,
}
