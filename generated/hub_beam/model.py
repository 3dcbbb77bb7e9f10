"""Hub with a flexible beam (F2): equations of motion, emitted by symgen from the scene `hub_beam`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 747 operations."""
    p = ca.SX.sym("p", 295)
    torque = p[0]
    hub_mass = p[1]
    hub_inertia = p[2]
    beam_length = p[3]
    beam_density = p[4]
    beam_area = p[5]
    beam_youngs_modulus = p[6]
    beam_second_moment = p[7]
    beam100_clamped_free3_kappa_lateral_0_0 = p[8]
    beam100_clamped_free3_kappa_lateral_1_1 = p[9]
    beam100_clamped_free3_kappa_lateral_2_2 = p[10]
    beam100_clamped_free3_mass_0_0 = p[11]
    beam100_clamped_free3_mass_1_1 = p[12]
    beam100_clamped_free3_mass_2_2 = p[13]
    beam100_clamped_free3_s1_0_0 = p[14]
    beam100_clamped_free3_i0_0_0 = p[15]
    beam100_clamped_free3_phi_y_0_0 = p[16]
    beam100_clamped_free3_phi_y_1_0 = p[17]
    beam100_clamped_free3_phi_y_2_0 = p[18]
    beam100_clamped_free3_xi_phi_y_0_0 = p[19]
    beam100_clamped_free3_xi_phi_y_1_0 = p[20]
    beam100_clamped_free3_xi_phi_y_2_0 = p[21]
    beam100_clamped_free3_H_0_0 = p[22]
    beam100_clamped_free3_H_0_1 = p[23]
    beam100_clamped_free3_H_0_2 = p[24]
    beam100_clamped_free3_H_1_0 = p[25]
    beam100_clamped_free3_H_1_1 = p[26]
    beam100_clamped_free3_H_1_2 = p[27]
    beam100_clamped_free3_H_2_0 = p[28]
    beam100_clamped_free3_H_2_1 = p[29]
    beam100_clamped_free3_H_2_2 = p[30]
    beam100_clamped_free3_xH_0_0 = p[31]
    beam100_clamped_free3_xH_0_1 = p[32]
    beam100_clamped_free3_xH_0_2 = p[33]
    beam100_clamped_free3_xH_1_0 = p[34]
    beam100_clamped_free3_xH_1_1 = p[35]
    beam100_clamped_free3_xH_1_2 = p[36]
    beam100_clamped_free3_xH_2_0 = p[37]
    beam100_clamped_free3_xH_2_1 = p[38]
    beam100_clamped_free3_xH_2_2 = p[39]
    beam100_clamped_free3_1_0_shape_1_0 = p[40]
    beam100_clamped_free3_1_0_shape_1_1 = p[41]
    beam100_clamped_free3_1_0_shape_1_2 = p[42]
    beam100_clamped_free3_1_0_H_0_0 = p[46]
    beam100_clamped_free3_1_0_H_0_1 = p[47]
    beam100_clamped_free3_1_0_H_0_2 = p[48]
    beam100_clamped_free3_1_0_H_1_0 = p[49]
    beam100_clamped_free3_1_0_H_1_1 = p[50]
    beam100_clamped_free3_1_0_H_1_2 = p[51]
    beam100_clamped_free3_1_0_H_2_0 = p[52]
    beam100_clamped_free3_1_0_H_2_1 = p[53]
    beam100_clamped_free3_1_0_H_2_2 = p[54]
    beam100_clamped_free3_0_0625_at_0_0 = p[55]
    beam100_clamped_free3_0_0625_shape_1_0 = p[56]
    beam100_clamped_free3_0_0625_shape_1_1 = p[57]
    beam100_clamped_free3_0_0625_shape_1_2 = p[58]
    beam100_clamped_free3_0_0625_H_0_0 = p[62]
    beam100_clamped_free3_0_0625_H_0_1 = p[63]
    beam100_clamped_free3_0_0625_H_0_2 = p[64]
    beam100_clamped_free3_0_0625_H_1_0 = p[65]
    beam100_clamped_free3_0_0625_H_1_1 = p[66]
    beam100_clamped_free3_0_0625_H_1_2 = p[67]
    beam100_clamped_free3_0_0625_H_2_0 = p[68]
    beam100_clamped_free3_0_0625_H_2_1 = p[69]
    beam100_clamped_free3_0_0625_H_2_2 = p[70]
    beam100_clamped_free3_0_125_at_0_0 = p[71]
    beam100_clamped_free3_0_125_shape_1_0 = p[72]
    beam100_clamped_free3_0_125_shape_1_1 = p[73]
    beam100_clamped_free3_0_125_shape_1_2 = p[74]
    beam100_clamped_free3_0_125_H_0_0 = p[78]
    beam100_clamped_free3_0_125_H_0_1 = p[79]
    beam100_clamped_free3_0_125_H_0_2 = p[80]
    beam100_clamped_free3_0_125_H_1_0 = p[81]
    beam100_clamped_free3_0_125_H_1_1 = p[82]
    beam100_clamped_free3_0_125_H_1_2 = p[83]
    beam100_clamped_free3_0_125_H_2_0 = p[84]
    beam100_clamped_free3_0_125_H_2_1 = p[85]
    beam100_clamped_free3_0_125_H_2_2 = p[86]
    beam100_clamped_free3_0_1875_at_0_0 = p[87]
    beam100_clamped_free3_0_1875_shape_1_0 = p[88]
    beam100_clamped_free3_0_1875_shape_1_1 = p[89]
    beam100_clamped_free3_0_1875_shape_1_2 = p[90]
    beam100_clamped_free3_0_1875_H_0_0 = p[94]
    beam100_clamped_free3_0_1875_H_0_1 = p[95]
    beam100_clamped_free3_0_1875_H_0_2 = p[96]
    beam100_clamped_free3_0_1875_H_1_0 = p[97]
    beam100_clamped_free3_0_1875_H_1_1 = p[98]
    beam100_clamped_free3_0_1875_H_1_2 = p[99]
    beam100_clamped_free3_0_1875_H_2_0 = p[100]
    beam100_clamped_free3_0_1875_H_2_1 = p[101]
    beam100_clamped_free3_0_1875_H_2_2 = p[102]
    beam100_clamped_free3_0_25_at_0_0 = p[103]
    beam100_clamped_free3_0_25_shape_1_0 = p[104]
    beam100_clamped_free3_0_25_shape_1_1 = p[105]
    beam100_clamped_free3_0_25_shape_1_2 = p[106]
    beam100_clamped_free3_0_25_H_0_0 = p[110]
    beam100_clamped_free3_0_25_H_0_1 = p[111]
    beam100_clamped_free3_0_25_H_0_2 = p[112]
    beam100_clamped_free3_0_25_H_1_0 = p[113]
    beam100_clamped_free3_0_25_H_1_1 = p[114]
    beam100_clamped_free3_0_25_H_1_2 = p[115]
    beam100_clamped_free3_0_25_H_2_0 = p[116]
    beam100_clamped_free3_0_25_H_2_1 = p[117]
    beam100_clamped_free3_0_25_H_2_2 = p[118]
    beam100_clamped_free3_0_3125_at_0_0 = p[119]
    beam100_clamped_free3_0_3125_shape_1_0 = p[120]
    beam100_clamped_free3_0_3125_shape_1_1 = p[121]
    beam100_clamped_free3_0_3125_shape_1_2 = p[122]
    beam100_clamped_free3_0_3125_H_0_0 = p[126]
    beam100_clamped_free3_0_3125_H_0_1 = p[127]
    beam100_clamped_free3_0_3125_H_0_2 = p[128]
    beam100_clamped_free3_0_3125_H_1_0 = p[129]
    beam100_clamped_free3_0_3125_H_1_1 = p[130]
    beam100_clamped_free3_0_3125_H_1_2 = p[131]
    beam100_clamped_free3_0_3125_H_2_0 = p[132]
    beam100_clamped_free3_0_3125_H_2_1 = p[133]
    beam100_clamped_free3_0_3125_H_2_2 = p[134]
    beam100_clamped_free3_0_375_at_0_0 = p[135]
    beam100_clamped_free3_0_375_shape_1_0 = p[136]
    beam100_clamped_free3_0_375_shape_1_1 = p[137]
    beam100_clamped_free3_0_375_shape_1_2 = p[138]
    beam100_clamped_free3_0_375_H_0_0 = p[142]
    beam100_clamped_free3_0_375_H_0_1 = p[143]
    beam100_clamped_free3_0_375_H_0_2 = p[144]
    beam100_clamped_free3_0_375_H_1_0 = p[145]
    beam100_clamped_free3_0_375_H_1_1 = p[146]
    beam100_clamped_free3_0_375_H_1_2 = p[147]
    beam100_clamped_free3_0_375_H_2_0 = p[148]
    beam100_clamped_free3_0_375_H_2_1 = p[149]
    beam100_clamped_free3_0_375_H_2_2 = p[150]
    beam100_clamped_free3_0_4375_at_0_0 = p[151]
    beam100_clamped_free3_0_4375_shape_1_0 = p[152]
    beam100_clamped_free3_0_4375_shape_1_1 = p[153]
    beam100_clamped_free3_0_4375_shape_1_2 = p[154]
    beam100_clamped_free3_0_4375_H_0_0 = p[158]
    beam100_clamped_free3_0_4375_H_0_1 = p[159]
    beam100_clamped_free3_0_4375_H_0_2 = p[160]
    beam100_clamped_free3_0_4375_H_1_0 = p[161]
    beam100_clamped_free3_0_4375_H_1_1 = p[162]
    beam100_clamped_free3_0_4375_H_1_2 = p[163]
    beam100_clamped_free3_0_4375_H_2_0 = p[164]
    beam100_clamped_free3_0_4375_H_2_1 = p[165]
    beam100_clamped_free3_0_4375_H_2_2 = p[166]
    beam100_clamped_free3_0_5_at_0_0 = p[167]
    beam100_clamped_free3_0_5_shape_1_0 = p[168]
    beam100_clamped_free3_0_5_shape_1_1 = p[169]
    beam100_clamped_free3_0_5_shape_1_2 = p[170]
    beam100_clamped_free3_0_5_H_0_0 = p[174]
    beam100_clamped_free3_0_5_H_0_1 = p[175]
    beam100_clamped_free3_0_5_H_0_2 = p[176]
    beam100_clamped_free3_0_5_H_1_0 = p[177]
    beam100_clamped_free3_0_5_H_1_1 = p[178]
    beam100_clamped_free3_0_5_H_1_2 = p[179]
    beam100_clamped_free3_0_5_H_2_0 = p[180]
    beam100_clamped_free3_0_5_H_2_1 = p[181]
    beam100_clamped_free3_0_5_H_2_2 = p[182]
    beam100_clamped_free3_0_5625_at_0_0 = p[183]
    beam100_clamped_free3_0_5625_shape_1_0 = p[184]
    beam100_clamped_free3_0_5625_shape_1_1 = p[185]
    beam100_clamped_free3_0_5625_shape_1_2 = p[186]
    beam100_clamped_free3_0_5625_H_0_0 = p[190]
    beam100_clamped_free3_0_5625_H_0_1 = p[191]
    beam100_clamped_free3_0_5625_H_0_2 = p[192]
    beam100_clamped_free3_0_5625_H_1_0 = p[193]
    beam100_clamped_free3_0_5625_H_1_1 = p[194]
    beam100_clamped_free3_0_5625_H_1_2 = p[195]
    beam100_clamped_free3_0_5625_H_2_0 = p[196]
    beam100_clamped_free3_0_5625_H_2_1 = p[197]
    beam100_clamped_free3_0_5625_H_2_2 = p[198]
    beam100_clamped_free3_0_625_at_0_0 = p[199]
    beam100_clamped_free3_0_625_shape_1_0 = p[200]
    beam100_clamped_free3_0_625_shape_1_1 = p[201]
    beam100_clamped_free3_0_625_shape_1_2 = p[202]
    beam100_clamped_free3_0_625_H_0_0 = p[206]
    beam100_clamped_free3_0_625_H_0_1 = p[207]
    beam100_clamped_free3_0_625_H_0_2 = p[208]
    beam100_clamped_free3_0_625_H_1_0 = p[209]
    beam100_clamped_free3_0_625_H_1_1 = p[210]
    beam100_clamped_free3_0_625_H_1_2 = p[211]
    beam100_clamped_free3_0_625_H_2_0 = p[212]
    beam100_clamped_free3_0_625_H_2_1 = p[213]
    beam100_clamped_free3_0_625_H_2_2 = p[214]
    beam100_clamped_free3_0_6875_at_0_0 = p[215]
    beam100_clamped_free3_0_6875_shape_1_0 = p[216]
    beam100_clamped_free3_0_6875_shape_1_1 = p[217]
    beam100_clamped_free3_0_6875_shape_1_2 = p[218]
    beam100_clamped_free3_0_6875_H_0_0 = p[222]
    beam100_clamped_free3_0_6875_H_0_1 = p[223]
    beam100_clamped_free3_0_6875_H_0_2 = p[224]
    beam100_clamped_free3_0_6875_H_1_0 = p[225]
    beam100_clamped_free3_0_6875_H_1_1 = p[226]
    beam100_clamped_free3_0_6875_H_1_2 = p[227]
    beam100_clamped_free3_0_6875_H_2_0 = p[228]
    beam100_clamped_free3_0_6875_H_2_1 = p[229]
    beam100_clamped_free3_0_6875_H_2_2 = p[230]
    beam100_clamped_free3_0_75_at_0_0 = p[231]
    beam100_clamped_free3_0_75_shape_1_0 = p[232]
    beam100_clamped_free3_0_75_shape_1_1 = p[233]
    beam100_clamped_free3_0_75_shape_1_2 = p[234]
    beam100_clamped_free3_0_75_H_0_0 = p[238]
    beam100_clamped_free3_0_75_H_0_1 = p[239]
    beam100_clamped_free3_0_75_H_0_2 = p[240]
    beam100_clamped_free3_0_75_H_1_0 = p[241]
    beam100_clamped_free3_0_75_H_1_1 = p[242]
    beam100_clamped_free3_0_75_H_1_2 = p[243]
    beam100_clamped_free3_0_75_H_2_0 = p[244]
    beam100_clamped_free3_0_75_H_2_1 = p[245]
    beam100_clamped_free3_0_75_H_2_2 = p[246]
    beam100_clamped_free3_0_8125_at_0_0 = p[247]
    beam100_clamped_free3_0_8125_shape_1_0 = p[248]
    beam100_clamped_free3_0_8125_shape_1_1 = p[249]
    beam100_clamped_free3_0_8125_shape_1_2 = p[250]
    beam100_clamped_free3_0_8125_H_0_0 = p[254]
    beam100_clamped_free3_0_8125_H_0_1 = p[255]
    beam100_clamped_free3_0_8125_H_0_2 = p[256]
    beam100_clamped_free3_0_8125_H_1_0 = p[257]
    beam100_clamped_free3_0_8125_H_1_1 = p[258]
    beam100_clamped_free3_0_8125_H_1_2 = p[259]
    beam100_clamped_free3_0_8125_H_2_0 = p[260]
    beam100_clamped_free3_0_8125_H_2_1 = p[261]
    beam100_clamped_free3_0_8125_H_2_2 = p[262]
    beam100_clamped_free3_0_875_at_0_0 = p[263]
    beam100_clamped_free3_0_875_shape_1_0 = p[264]
    beam100_clamped_free3_0_875_shape_1_1 = p[265]
    beam100_clamped_free3_0_875_shape_1_2 = p[266]
    beam100_clamped_free3_0_875_H_0_0 = p[270]
    beam100_clamped_free3_0_875_H_0_1 = p[271]
    beam100_clamped_free3_0_875_H_0_2 = p[272]
    beam100_clamped_free3_0_875_H_1_0 = p[273]
    beam100_clamped_free3_0_875_H_1_1 = p[274]
    beam100_clamped_free3_0_875_H_1_2 = p[275]
    beam100_clamped_free3_0_875_H_2_0 = p[276]
    beam100_clamped_free3_0_875_H_2_1 = p[277]
    beam100_clamped_free3_0_875_H_2_2 = p[278]
    beam100_clamped_free3_0_9375_at_0_0 = p[279]
    beam100_clamped_free3_0_9375_shape_1_0 = p[280]
    beam100_clamped_free3_0_9375_shape_1_1 = p[281]
    beam100_clamped_free3_0_9375_shape_1_2 = p[282]
    beam100_clamped_free3_0_9375_H_0_0 = p[286]
    beam100_clamped_free3_0_9375_H_0_1 = p[287]
    beam100_clamped_free3_0_9375_H_0_2 = p[288]
    beam100_clamped_free3_0_9375_H_1_0 = p[289]
    beam100_clamped_free3_0_9375_H_1_1 = p[290]
    beam100_clamped_free3_0_9375_H_1_2 = p[291]
    beam100_clamped_free3_0_9375_H_2_0 = p[292]
    beam100_clamped_free3_0_9375_H_2_1 = p[293]
    beam100_clamped_free3_0_9375_H_2_2 = p[294]
    w0 = beam_density * beam_area
    w1 = w0 * beam_length
    w2 = beam_length**2
    w3 = w1 * w2 * beam100_clamped_free3_i0_0_0
    w4 = w1 * beam100_clamped_free3_mass_0_0
    w5 = w1 * beam100_clamped_free3_xH_0_0
    w6 = w1 * beam100_clamped_free3_xH_0_1
    w7 = w1 * beam100_clamped_free3_xH_0_2
    w8 = w1 * beam100_clamped_free3_mass_1_1
    w9 = w1 * beam100_clamped_free3_xH_1_0
    w10 = w1 * beam100_clamped_free3_xH_1_1
    w11 = w1 * beam100_clamped_free3_xH_1_2
    w12 = w1 * beam100_clamped_free3_mass_2_2
    w13 = w1 * beam100_clamped_free3_xH_2_0
    w14 = w1 * beam100_clamped_free3_xH_2_1
    w15 = w1 * beam100_clamped_free3_xH_2_2
    w16 = beam_length * w1
    w17 = w16 * beam100_clamped_free3_xi_phi_y_0_0
    w18 = w16 * beam100_clamped_free3_xi_phi_y_1_0
    w19 = w16 * beam100_clamped_free3_xi_phi_y_2_0
    w20 = beam_youngs_modulus * beam_second_moment / (beam_length * w2)
    w21 = beam_length * (beam_area * (2 * beam_density))
    w22 = beam_length * (beam_area * (beam_density * -2.0))
    w23 = w19 / w12
    w24 = w18 / w8
    w25 = w17 / w4
    c = ca.vertcat(
        w4,
        w5,
        w6,
        w7,
        w8,
        w9,
        w10,
        w11,
        w12,
        w13,
        w14,
        w15,
        hub_inertia + w3,
        w17,
        w18,
        w19,
        torque,
        w20 * beam100_clamped_free3_kappa_lateral_0_0,
        w20 * beam100_clamped_free3_kappa_lateral_1_1,
        w20 * beam100_clamped_free3_kappa_lateral_2_2,
        hub_inertia,
        w1,
        w3,
        hub_mass,
        w16 * beam100_clamped_free3_s1_0_0,
        w0 * beam100_clamped_free3_H_0_0,
        w0 * beam100_clamped_free3_H_0_1,
        w0 * beam100_clamped_free3_H_0_2,
        w0 * beam100_clamped_free3_H_1_0,
        w0 * beam100_clamped_free3_H_1_1,
        w0 * beam100_clamped_free3_H_1_2,
        w0 * beam100_clamped_free3_H_2_0,
        w0 * beam100_clamped_free3_H_2_1,
        w0 * beam100_clamped_free3_H_2_2,
        w1 * beam100_clamped_free3_phi_y_0_0,
        w1 * beam100_clamped_free3_phi_y_1_0,
        w1 * beam100_clamped_free3_phi_y_2_0,
        beam_length,
        beam100_clamped_free3_1_0_H_0_0 / beam_length,
        beam100_clamped_free3_1_0_H_0_1 / beam_length,
        beam100_clamped_free3_1_0_H_0_2 / beam_length,
        beam100_clamped_free3_1_0_H_1_0 / beam_length,
        beam100_clamped_free3_1_0_H_1_1 / beam_length,
        beam100_clamped_free3_1_0_H_1_2 / beam_length,
        beam100_clamped_free3_1_0_H_2_0 / beam_length,
        beam100_clamped_free3_1_0_H_2_1 / beam_length,
        beam100_clamped_free3_1_0_H_2_2 / beam_length,
        beam100_clamped_free3_1_0_shape_1_0,
        beam100_clamped_free3_1_0_shape_1_1,
        beam100_clamped_free3_1_0_shape_1_2,
        beam_length * beam100_clamped_free3_0_0625_at_0_0,
        beam100_clamped_free3_0_0625_H_0_0 / beam_length,
        beam100_clamped_free3_0_0625_H_0_1 / beam_length,
        beam100_clamped_free3_0_0625_H_0_2 / beam_length,
        beam100_clamped_free3_0_0625_H_1_0 / beam_length,
        beam100_clamped_free3_0_0625_H_1_1 / beam_length,
        beam100_clamped_free3_0_0625_H_1_2 / beam_length,
        beam100_clamped_free3_0_0625_H_2_0 / beam_length,
        beam100_clamped_free3_0_0625_H_2_1 / beam_length,
        beam100_clamped_free3_0_0625_H_2_2 / beam_length,
        beam100_clamped_free3_0_0625_shape_1_0,
        beam100_clamped_free3_0_0625_shape_1_1,
        beam100_clamped_free3_0_0625_shape_1_2,
        beam_length * beam100_clamped_free3_0_125_at_0_0,
        beam100_clamped_free3_0_125_H_0_0 / beam_length,
        beam100_clamped_free3_0_125_H_0_1 / beam_length,
        beam100_clamped_free3_0_125_H_0_2 / beam_length,
        beam100_clamped_free3_0_125_H_1_0 / beam_length,
        beam100_clamped_free3_0_125_H_1_1 / beam_length,
        beam100_clamped_free3_0_125_H_1_2 / beam_length,
        beam100_clamped_free3_0_125_H_2_0 / beam_length,
        beam100_clamped_free3_0_125_H_2_1 / beam_length,
        beam100_clamped_free3_0_125_H_2_2 / beam_length,
        beam100_clamped_free3_0_125_shape_1_0,
        beam100_clamped_free3_0_125_shape_1_1,
        beam100_clamped_free3_0_125_shape_1_2,
        beam_length * beam100_clamped_free3_0_1875_at_0_0,
        beam100_clamped_free3_0_1875_H_0_0 / beam_length,
        beam100_clamped_free3_0_1875_H_0_1 / beam_length,
        beam100_clamped_free3_0_1875_H_0_2 / beam_length,
        beam100_clamped_free3_0_1875_H_1_0 / beam_length,
        beam100_clamped_free3_0_1875_H_1_1 / beam_length,
        beam100_clamped_free3_0_1875_H_1_2 / beam_length,
        beam100_clamped_free3_0_1875_H_2_0 / beam_length,
        beam100_clamped_free3_0_1875_H_2_1 / beam_length,
        beam100_clamped_free3_0_1875_H_2_2 / beam_length,
        beam100_clamped_free3_0_1875_shape_1_0,
        beam100_clamped_free3_0_1875_shape_1_1,
        beam100_clamped_free3_0_1875_shape_1_2,
        beam_length * beam100_clamped_free3_0_25_at_0_0,
        beam100_clamped_free3_0_25_H_0_0 / beam_length,
        beam100_clamped_free3_0_25_H_0_1 / beam_length,
        beam100_clamped_free3_0_25_H_0_2 / beam_length,
        beam100_clamped_free3_0_25_H_1_0 / beam_length,
        beam100_clamped_free3_0_25_H_1_1 / beam_length,
        beam100_clamped_free3_0_25_H_1_2 / beam_length,
        beam100_clamped_free3_0_25_H_2_0 / beam_length,
        beam100_clamped_free3_0_25_H_2_1 / beam_length,
        beam100_clamped_free3_0_25_H_2_2 / beam_length,
        beam100_clamped_free3_0_25_shape_1_0,
        beam100_clamped_free3_0_25_shape_1_1,
        beam100_clamped_free3_0_25_shape_1_2,
        beam_length * beam100_clamped_free3_0_3125_at_0_0,
        beam100_clamped_free3_0_3125_H_0_0 / beam_length,
        beam100_clamped_free3_0_3125_H_0_1 / beam_length,
        beam100_clamped_free3_0_3125_H_0_2 / beam_length,
        beam100_clamped_free3_0_3125_H_1_0 / beam_length,
        beam100_clamped_free3_0_3125_H_1_1 / beam_length,
        beam100_clamped_free3_0_3125_H_1_2 / beam_length,
        beam100_clamped_free3_0_3125_H_2_0 / beam_length,
        beam100_clamped_free3_0_3125_H_2_1 / beam_length,
        beam100_clamped_free3_0_3125_H_2_2 / beam_length,
        beam100_clamped_free3_0_3125_shape_1_0,
        beam100_clamped_free3_0_3125_shape_1_1,
        beam100_clamped_free3_0_3125_shape_1_2,
        beam_length * beam100_clamped_free3_0_375_at_0_0,
        beam100_clamped_free3_0_375_H_0_0 / beam_length,
        beam100_clamped_free3_0_375_H_0_1 / beam_length,
        beam100_clamped_free3_0_375_H_0_2 / beam_length,
        beam100_clamped_free3_0_375_H_1_0 / beam_length,
        beam100_clamped_free3_0_375_H_1_1 / beam_length,
        beam100_clamped_free3_0_375_H_1_2 / beam_length,
        beam100_clamped_free3_0_375_H_2_0 / beam_length,
        beam100_clamped_free3_0_375_H_2_1 / beam_length,
        beam100_clamped_free3_0_375_H_2_2 / beam_length,
        beam100_clamped_free3_0_375_shape_1_0,
        beam100_clamped_free3_0_375_shape_1_1,
        beam100_clamped_free3_0_375_shape_1_2,
        beam_length * beam100_clamped_free3_0_4375_at_0_0,
        beam100_clamped_free3_0_4375_H_0_0 / beam_length,
        beam100_clamped_free3_0_4375_H_0_1 / beam_length,
        beam100_clamped_free3_0_4375_H_0_2 / beam_length,
        beam100_clamped_free3_0_4375_H_1_0 / beam_length,
        beam100_clamped_free3_0_4375_H_1_1 / beam_length,
        beam100_clamped_free3_0_4375_H_1_2 / beam_length,
        beam100_clamped_free3_0_4375_H_2_0 / beam_length,
        beam100_clamped_free3_0_4375_H_2_1 / beam_length,
        beam100_clamped_free3_0_4375_H_2_2 / beam_length,
        beam100_clamped_free3_0_4375_shape_1_0,
        beam100_clamped_free3_0_4375_shape_1_1,
        beam100_clamped_free3_0_4375_shape_1_2,
        beam_length * beam100_clamped_free3_0_5_at_0_0,
        beam100_clamped_free3_0_5_H_0_0 / beam_length,
        beam100_clamped_free3_0_5_H_0_1 / beam_length,
        beam100_clamped_free3_0_5_H_0_2 / beam_length,
        beam100_clamped_free3_0_5_H_1_0 / beam_length,
        beam100_clamped_free3_0_5_H_1_1 / beam_length,
        beam100_clamped_free3_0_5_H_1_2 / beam_length,
        beam100_clamped_free3_0_5_H_2_0 / beam_length,
        beam100_clamped_free3_0_5_H_2_1 / beam_length,
        beam100_clamped_free3_0_5_H_2_2 / beam_length,
        beam100_clamped_free3_0_5_shape_1_0,
        beam100_clamped_free3_0_5_shape_1_1,
        beam100_clamped_free3_0_5_shape_1_2,
        beam_length * beam100_clamped_free3_0_5625_at_0_0,
        beam100_clamped_free3_0_5625_H_0_0 / beam_length,
        beam100_clamped_free3_0_5625_H_0_1 / beam_length,
        beam100_clamped_free3_0_5625_H_0_2 / beam_length,
        beam100_clamped_free3_0_5625_H_1_0 / beam_length,
        beam100_clamped_free3_0_5625_H_1_1 / beam_length,
        beam100_clamped_free3_0_5625_H_1_2 / beam_length,
        beam100_clamped_free3_0_5625_H_2_0 / beam_length,
        beam100_clamped_free3_0_5625_H_2_1 / beam_length,
        beam100_clamped_free3_0_5625_H_2_2 / beam_length,
        beam100_clamped_free3_0_5625_shape_1_0,
        beam100_clamped_free3_0_5625_shape_1_1,
        beam100_clamped_free3_0_5625_shape_1_2,
        beam_length * beam100_clamped_free3_0_625_at_0_0,
        beam100_clamped_free3_0_625_H_0_0 / beam_length,
        beam100_clamped_free3_0_625_H_0_1 / beam_length,
        beam100_clamped_free3_0_625_H_0_2 / beam_length,
        beam100_clamped_free3_0_625_H_1_0 / beam_length,
        beam100_clamped_free3_0_625_H_1_1 / beam_length,
        beam100_clamped_free3_0_625_H_1_2 / beam_length,
        beam100_clamped_free3_0_625_H_2_0 / beam_length,
        beam100_clamped_free3_0_625_H_2_1 / beam_length,
        beam100_clamped_free3_0_625_H_2_2 / beam_length,
        beam100_clamped_free3_0_625_shape_1_0,
        beam100_clamped_free3_0_625_shape_1_1,
        beam100_clamped_free3_0_625_shape_1_2,
        beam_length * beam100_clamped_free3_0_6875_at_0_0,
        beam100_clamped_free3_0_6875_H_0_0 / beam_length,
        beam100_clamped_free3_0_6875_H_0_1 / beam_length,
        beam100_clamped_free3_0_6875_H_0_2 / beam_length,
        beam100_clamped_free3_0_6875_H_1_0 / beam_length,
        beam100_clamped_free3_0_6875_H_1_1 / beam_length,
        beam100_clamped_free3_0_6875_H_1_2 / beam_length,
        beam100_clamped_free3_0_6875_H_2_0 / beam_length,
        beam100_clamped_free3_0_6875_H_2_1 / beam_length,
        beam100_clamped_free3_0_6875_H_2_2 / beam_length,
        beam100_clamped_free3_0_6875_shape_1_0,
        beam100_clamped_free3_0_6875_shape_1_1,
        beam100_clamped_free3_0_6875_shape_1_2,
        beam_length * beam100_clamped_free3_0_75_at_0_0,
        beam100_clamped_free3_0_75_H_0_0 / beam_length,
        beam100_clamped_free3_0_75_H_0_1 / beam_length,
        beam100_clamped_free3_0_75_H_0_2 / beam_length,
        beam100_clamped_free3_0_75_H_1_0 / beam_length,
        beam100_clamped_free3_0_75_H_1_1 / beam_length,
        beam100_clamped_free3_0_75_H_1_2 / beam_length,
        beam100_clamped_free3_0_75_H_2_0 / beam_length,
        beam100_clamped_free3_0_75_H_2_1 / beam_length,
        beam100_clamped_free3_0_75_H_2_2 / beam_length,
        beam100_clamped_free3_0_75_shape_1_0,
        beam100_clamped_free3_0_75_shape_1_1,
        beam100_clamped_free3_0_75_shape_1_2,
        beam_length * beam100_clamped_free3_0_8125_at_0_0,
        beam100_clamped_free3_0_8125_H_0_0 / beam_length,
        beam100_clamped_free3_0_8125_H_0_1 / beam_length,
        beam100_clamped_free3_0_8125_H_0_2 / beam_length,
        beam100_clamped_free3_0_8125_H_1_0 / beam_length,
        beam100_clamped_free3_0_8125_H_1_1 / beam_length,
        beam100_clamped_free3_0_8125_H_1_2 / beam_length,
        beam100_clamped_free3_0_8125_H_2_0 / beam_length,
        beam100_clamped_free3_0_8125_H_2_1 / beam_length,
        beam100_clamped_free3_0_8125_H_2_2 / beam_length,
        beam100_clamped_free3_0_8125_shape_1_0,
        beam100_clamped_free3_0_8125_shape_1_1,
        beam100_clamped_free3_0_8125_shape_1_2,
        beam_length * beam100_clamped_free3_0_875_at_0_0,
        beam100_clamped_free3_0_875_H_0_0 / beam_length,
        beam100_clamped_free3_0_875_H_0_1 / beam_length,
        beam100_clamped_free3_0_875_H_0_2 / beam_length,
        beam100_clamped_free3_0_875_H_1_0 / beam_length,
        beam100_clamped_free3_0_875_H_1_1 / beam_length,
        beam100_clamped_free3_0_875_H_1_2 / beam_length,
        beam100_clamped_free3_0_875_H_2_0 / beam_length,
        beam100_clamped_free3_0_875_H_2_1 / beam_length,
        beam100_clamped_free3_0_875_H_2_2 / beam_length,
        beam100_clamped_free3_0_875_shape_1_0,
        beam100_clamped_free3_0_875_shape_1_1,
        beam100_clamped_free3_0_875_shape_1_2,
        beam_length * beam100_clamped_free3_0_9375_at_0_0,
        beam100_clamped_free3_0_9375_H_0_0 / beam_length,
        beam100_clamped_free3_0_9375_H_0_1 / beam_length,
        beam100_clamped_free3_0_9375_H_0_2 / beam_length,
        beam100_clamped_free3_0_9375_H_1_0 / beam_length,
        beam100_clamped_free3_0_9375_H_1_1 / beam_length,
        beam100_clamped_free3_0_9375_H_1_2 / beam_length,
        beam100_clamped_free3_0_9375_H_2_0 / beam_length,
        beam100_clamped_free3_0_9375_H_2_1 / beam_length,
        beam100_clamped_free3_0_9375_H_2_2 / beam_length,
        beam100_clamped_free3_0_9375_shape_1_0,
        beam100_clamped_free3_0_9375_shape_1_1,
        beam100_clamped_free3_0_9375_shape_1_2,
        w4 - w5,
        w8 - w10,
        w12 - w15,
        -w9,
        -w13,
        -w6,
        -w14,
        -w7,
        -w11,
        w6 + w9,
        w7 + w13,
        w11 + w14,
        beam100_clamped_free3_mass_0_0 * w21 + beam100_clamped_free3_xH_0_0 * w22,
        beam100_clamped_free3_mass_1_1 * w21 + beam100_clamped_free3_xH_1_1 * w22,
        beam100_clamped_free3_mass_2_2 * w21 + beam100_clamped_free3_xH_2_2 * w22,
        w23,
        w24,
        w25,
        w19 * w23,
        w18 * w24,
        w17 * w25,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 102 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 266)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
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
    w0 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w1 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w2 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w3 = ca.if_else(t < 2.0, ca.sin(t * 3.141592653589793) * c16, 0) + beam_theta_dot * -2.0 * (w0 * beam_q1_dot + w1 * beam_q2_dot + w2 * beam_q3_dot)
    w4 = beam_theta_dot**2
    M_hat = ca.vertcat(
        beam_q3 * w2 + (beam_q2 * w1 + (beam_q1 * w0 + c12)),
        c13,
        c14,
        c15,
        c13,
        c0,
        0.0,
        0.0,
        c14,
        0.0,
        c4,
        0.0,
        c15,
        0.0,
        0.0,
        c8,
    )
    M_hat = ca.reshape(M_hat, 4, 4)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w3,
        w0 * w4 - beam_q1 * c17,
        w1 * w4 - beam_q2 * c18,
        w2 * w4 - beam_q3 * c19,
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_i_dot, q_d_dot, t, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_i_dot", "q_d_dot", "t", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 7 operations."""
    q_i = ca.SX.sym("q_i", 4)
    hub_theta = q_i[0]
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        hub_theta,
    )
    q_d_next = ca.densify(q_d_next)
    inputs, outputs = [q_i], [q_d_next]
    return ca.Function("closure", inputs, outputs, ["q_i"], ["q_d_next"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 7 operations."""
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    hub_theta_dot = q_i_dot[0]
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        hub_theta_dot,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [q_i_dot], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["q_i_dot"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 7 operations."""
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    hub_theta_ddot = q_i_ddot[0]
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        hub_theta_ddot,
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [q_i_ddot], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["q_i_ddot"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 77 operations."""
    q = ca.SX.sym("q", 9)
    hub_x = q[0]
    hub_y = q[1]
    hub_theta = q[2]
    beam_x = q[3]
    beam_y = q[4]
    beam_theta = q[5]
    C = ca.vertcat(
        hub_x,
        hub_y,
        beam_x - hub_x,
        beam_y - hub_y,
        beam_theta - hub_theta,
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        1.0,
        0.0,
        -1.0,
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
        -1.0,
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
        0.0,
        0.0,
        0.0,
        1.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 5, 9)
    C_q = ca.densify(C_q)
    C_t = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    C_t = ca.densify(C_t)
    nu = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    nu = ca.densify(nu)
    gamma = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 444 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 266)
    beam_theta = q[5]
    beam_q1 = q[6]
    beam_q2 = q[7]
    beam_q3 = q[8]
    beam_theta_dot = q_dot[5]
    beam_q1_dot = q_dot[6]
    beam_q2_dot = q_dot[7]
    beam_q3_dot = q_dot[8]
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
    w0 = ca.sin(beam_theta)
    w1 = beam_q1 * c25 + beam_q2 * c26 + beam_q3 * c27
    w2 = beam_q1 * c28 + beam_q2 * c29 + beam_q3 * c30
    w3 = beam_q1 * c31 + beam_q2 * c32 + beam_q3 * c33
    w4 = c24 - (beam_q1 * w1 + beam_q2 * w2 + beam_q3 * w3) * 0.5
    w5 = ca.cos(beam_theta)
    w6 = beam_q1 * c34 + beam_q2 * c35 + beam_q3 * c36
    w7 = w0 * w4 + w5 * w6
    w8 = -w7
    w9 = -(w1 * w5 + w0 * c34)
    w10 = -(w2 * w5 + w0 * c35)
    w11 = -(w3 * w5 + w0 * c36)
    w12 = w4 * w5 - w0 * w6
    w13 = w5 * c34 - w0 * w1
    w14 = w5 * c35 - w0 * w2
    w15 = w5 * c36 - w0 * w3
    w16 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w17 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w18 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w19 = beam_theta_dot**2
    w20 = 2 * beam_theta_dot
    w21 = beam_q1_dot * c34 + beam_q2_dot * c35 + beam_q3_dot * c36
    w22 = w1 * beam_q1_dot + w2 * beam_q2_dot + w3 * beam_q3_dot
    w23 = beam_q1_dot * (beam_q1_dot * c25 + beam_q2_dot * c26 + beam_q3_dot * c27) + beam_q2_dot * (beam_q1_dot * c28 + beam_q2_dot * c29 + beam_q3_dot * c30)
    w24 = w23 + beam_q3_dot * (beam_q1_dot * c31 + beam_q2_dot * c32 + beam_q3_dot * c33)
    w25 = w12 * w19 + w20 * (w5 * w21 - w0 * w22) + w5 * w24
    w26 = w7 * w19 + w0 * w24 + w20 * (w5 * w22 + w0 * w21)
    w27 = beam_theta_dot * -2.0 * (w16 * beam_q1_dot + w17 * beam_q2_dot + w18 * beam_q3_dot)
    w28 = w16 * w19
    w29 = w17 * w19
    w30 = w18 * w19
    w31 = ca.if_else(t < 2.0, ca.sin(t * 3.141592653589793) * c16, 0)
    M = ca.vertcat(
        c23,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c23,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c20,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c21,
        0.0,
        w8,
        w9,
        w10,
        w11,
        0.0,
        0.0,
        0.0,
        0.0,
        c21,
        w12,
        w13,
        w14,
        w15,
        0.0,
        0.0,
        0.0,
        w8,
        w12,
        c22 + (beam_q1 * w16 + beam_q2 * w17 + beam_q3 * w18),
        c13,
        c14,
        c15,
        0.0,
        0.0,
        0.0,
        w9,
        w13,
        c13,
        c0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        w10,
        w14,
        c14,
        0.0,
        c4,
        0.0,
        0.0,
        0.0,
        0.0,
        w11,
        w15,
        c15,
        0.0,
        0.0,
        c8,
    )
    M = ca.reshape(M, 9, 9)
    M = ca.densify(M)
    K = ca.vertcat(
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
        0.0,
        0.0,
        0.0,
        0.0,
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
        c18,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c19,
    )
    K = ca.reshape(K, 9, 9)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        0.0,
        0.0,
        0.0,
        w25,
        w26,
        w27,
        w28,
        w29,
        w30,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        0.0,
        w31,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        0.0,
        0.0,
        w31,
        w25,
        w26,
        w27,
        w28 - beam_q1 * c17,
        w29 - beam_q2 * c18,
        w30 - beam_q3 * c19,
    )
    Q_star = ca.densify(Q_star)
    C_q = ca.vertcat(
        1.0,
        0.0,
        -1.0,
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
        -1.0,
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
        0.0,
        0.0,
        0.0,
        1.0,
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
        0.0,
        0.0,
        0.0,
        0.0,
    )
    C_q = ca.reshape(C_q, 5, 9)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, t, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "t", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 237 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    q_ddot = ca.SX.sym("q_ddot", 9)
    c = ca.SX.sym("c", 266)
    beam_theta = q[5]
    beam_q1 = q[6]
    beam_q2 = q[7]
    beam_q3 = q[8]
    beam_theta_dot = q_dot[5]
    beam_q1_dot = q_dot[6]
    beam_q2_dot = q_dot[7]
    beam_q3_dot = q_dot[8]
    hub_x_ddot = q_ddot[0]
    hub_y_ddot = q_ddot[1]
    beam_x_ddot = q_ddot[3]
    beam_y_ddot = q_ddot[4]
    beam_theta_ddot = q_ddot[5]
    beam_q1_ddot = q_ddot[6]
    beam_q2_ddot = q_ddot[7]
    beam_q3_ddot = q_ddot[8]
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
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
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
    w0 = beam_theta_dot**2
    w1 = ca.cos(beam_theta)
    w2 = beam_q1 * c25 + beam_q2 * c26 + beam_q3 * c27
    w3 = beam_q1 * c28 + beam_q2 * c29 + beam_q3 * c30
    w4 = beam_q1 * c31 + beam_q2 * c32 + beam_q3 * c33
    w5 = c24 - (beam_q1 * w2 + beam_q2 * w3 + beam_q3 * w4) * 0.5
    w6 = ca.sin(beam_theta)
    w7 = beam_q1 * c34 + beam_q2 * c35 + beam_q3 * c36
    w8 = w1 * w5 - w6 * w7
    w9 = 2 * beam_theta_dot
    w10 = beam_q1_dot * c34 + beam_q2_dot * c35 + beam_q3_dot * c36
    w11 = w2 * beam_q1_dot + w3 * beam_q2_dot + w4 * beam_q3_dot
    w12 = beam_q1_dot * (beam_q1_dot * c25 + beam_q2_dot * c26 + beam_q3_dot * c27) + beam_q2_dot * (beam_q1_dot * c28 + beam_q2_dot * c29 + beam_q3_dot * c30)
    w13 = w12 + beam_q3_dot * (beam_q1_dot * c31 + beam_q2_dot * c32 + beam_q3_dot * c33)
    w14 = w5 * w6 + w1 * w7
    w15 = beam_x_ddot * c21 - w14 * beam_theta_ddot - (w1 * w2 + w6 * c34) * beam_q1_ddot - (w1 * w3 + w6 * c35) * beam_q2_ddot
    w16 = w0 * w8 + w9 * (w1 * w10 - w6 * w11) + w1 * w13 - (w15 - (w1 * w4 + w6 * c36) * beam_q3_ddot)
    w17 = w16 - hub_x_ddot * c23
    w18 = beam_y_ddot * c21 + w8 * beam_theta_ddot + beam_q1_ddot * (w1 * c34 - w2 * w6) + beam_q2_ddot * (w1 * c35 - w3 * w6)
    w19 = w0 * w14 + w6 * w13 + w9 * (w1 * w11 + w6 * w10) - (w18 + beam_q3_ddot * (w1 * c36 - w4 * w6))
    w20 = w19 - hub_y_ddot * c23
    w21 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w22 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w23 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w24 = w8 * beam_y_ddot - beam_x_ddot * w14 + beam_theta_ddot * (c22 + (beam_q1 * w21 + beam_q2 * w22 + beam_q3 * w23))
    w25 = beam_theta_dot * -2.0 * (beam_q1_dot * w21 + beam_q2_dot * w22 + beam_q3_dot * w23) - (w24 + beam_q1_ddot * c13 + beam_q2_ddot * c14 + beam_q3_ddot * c15)
    lam = ca.vertcat(
        w17,
        w20,
        w16,
        w19,
        w25,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w17,
        -w20,
        0.0,
        -w16,
        -w19,
        -w25,
    )
    joint_forces = ca.reshape(joint_forces, 3, 2)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 225 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 266)
    beam_theta = q[5]
    beam_q1 = q[6]
    beam_q2 = q[7]
    beam_q3 = q[8]
    hub_x_dot = q_dot[0]
    hub_y_dot = q_dot[1]
    hub_theta_dot = q_dot[2]
    beam_x_dot = q_dot[3]
    beam_y_dot = q_dot[4]
    beam_theta_dot = q_dot[5]
    beam_q1_dot = q_dot[6]
    beam_q2_dot = q_dot[7]
    beam_q3_dot = q_dot[8]
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
    w0 = hub_x_dot * (hub_x_dot * c23) + hub_y_dot * (hub_y_dot * c23) + hub_theta_dot * (hub_theta_dot * c20)
    w1 = ca.sin(beam_theta)
    w2 = beam_q1 * c25 + beam_q2 * c26 + beam_q3 * c27
    w3 = beam_q1 * c28 + beam_q2 * c29 + beam_q3 * c30
    w4 = beam_q1 * c31 + beam_q2 * c32 + beam_q3 * c33
    w5 = c24 - (beam_q1 * w2 + beam_q2 * w3 + beam_q3 * w4) * 0.5
    w6 = ca.cos(beam_theta)
    w7 = beam_q1 * c34 + beam_q2 * c35 + beam_q3 * c36
    w8 = w1 * w5 + w6 * w7
    w9 = w2 * w6 + w1 * c34
    w10 = w3 * w6 + w1 * c35
    w11 = w4 * w6 + w1 * c36
    w12 = beam_x_dot * c21 - w8 * beam_theta_dot - w9 * beam_q1_dot - w10 * beam_q2_dot - w11 * beam_q3_dot
    w13 = w5 * w6 - w1 * w7
    w14 = w6 * c34 - w1 * w2
    w15 = w6 * c35 - w1 * w3
    w16 = w6 * c36 - w1 * w4
    w17 = beam_y_dot * c21 + beam_theta_dot * w13 + beam_q1_dot * w14 + beam_q2_dot * w15 + beam_q3_dot * w16
    w18 = beam_q1 * (beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)) + beam_q2 * (beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7))
    w19 = beam_theta_dot * (c22 + (w18 + beam_q3 * (beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11))))
    w20 = beam_y_dot * w13 - beam_x_dot * w8 + w19 + beam_q1_dot * c13 + beam_q2_dot * c14 + beam_q3_dot * c15
    w21 = w0 + beam_x_dot * w12 + beam_y_dot * w17 + beam_theta_dot * w20 + beam_q1_dot * (beam_y_dot * w14 - beam_x_dot * w9 + beam_theta_dot * c13 + beam_q1_dot * c0)
    w22 = w21 + beam_q2_dot * (beam_y_dot * w15 - beam_x_dot * w10 + beam_theta_dot * c14 + beam_q2_dot * c4)
    w23 = w22 + beam_q3_dot * (beam_y_dot * w16 - beam_x_dot * w11 + beam_theta_dot * c15 + beam_q3_dot * c8)
    kinetic = ca.vertcat(
        w23 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        (beam_q1 * (beam_q1 * c17) + beam_q2 * (beam_q2 * c18) + beam_q3 * (beam_q3 * c19)) / 2.0,
    )
    elastic = ca.densify(elastic)
    potential = ca.vertcat(
        0.0,
    )
    potential = ca.densify(potential)
    power_dissipated = ca.vertcat(
        0.0,
    )
    power_dissipated = ca.densify(power_dissipated)
    power_applied = ca.vertcat(
        ca.if_else(t < 2.0, hub_theta_dot * (ca.sin(t * 3.141592653589793) * c16), 0),
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, t, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "t", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def measures() -> ca.Function:
    """The scene's measures and their rates. 117 operations."""
    q = ca.SX.sym("q", 9)
    q_dot = ca.SX.sym("q_dot", 9)
    c = ca.SX.sym("c", 266)
    beam_x = q[3]
    beam_y = q[4]
    beam_theta = q[5]
    beam_q1 = q[6]
    beam_q2 = q[7]
    beam_q3 = q[8]
    beam_x_dot = q_dot[3]
    beam_y_dot = q_dot[4]
    beam_theta_dot = q_dot[5]
    beam_q1_dot = q_dot[6]
    beam_q2_dot = q_dot[7]
    beam_q3_dot = q_dot[8]
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
    w0 = ca.cos(beam_theta)
    w1 = beam_q1 * c38 + beam_q2 * c39 + beam_q3 * c40
    w2 = beam_q1 * c41 + beam_q2 * c42 + beam_q3 * c43
    w3 = beam_q1 * c44 + beam_q2 * c45 + beam_q3 * c46
    w4 = c37 - (beam_q1 * w1 + beam_q2 * w2 + beam_q3 * w3) * 0.5
    w5 = ca.sin(beam_theta)
    w6 = beam_q1 * c47 + beam_q2 * c48 + beam_q3 * c49
    w7 = w5 * beam_theta_dot
    w8 = w1 * beam_q1_dot + beam_q1 * (beam_q1_dot * c38 + beam_q2_dot * c39 + beam_q3_dot * c40) + (w2 * beam_q2_dot + beam_q2 * (beam_q1_dot * c41 + beam_q2_dot * c42 + beam_q3_dot * c43))
    w9 = (w8 + (w3 * beam_q3_dot + beam_q3 * (beam_q1_dot * c44 + beam_q2_dot * c45 + beam_q3_dot * c46))) * 0.5
    w10 = w0 * beam_theta_dot
    w11 = beam_q1_dot * c47 + beam_q2_dot * c48 + beam_q3_dot * c49
    measures = ca.vertcat(
        beam_x + (w0 * w4 - w5 * w6),
        beam_x_dot - (w4 * w7 + w0 * w9 + (w6 * w10 + w5 * w11)),
        beam_y + (w4 * w5 + w0 * w6),
        beam_y_dot + (w4 * w10 - w5 * w9 + (w0 * w11 - w6 * w7)),
    )
    measures = ca.densify(measures)
    inputs, outputs = [q, q_dot, c], [measures]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot", "c"], ["measures"])


def drawing() -> ca.Function:
    """World points of the polylines that show the bodies. 819 operations."""
    q = ca.SX.sym("q", 9)
    exaggeration = ca.SX.sym("exaggeration", 1)
    c = ca.SX.sym("c", 266)
    hub_x = q[0]
    hub_y = q[1]
    beam_x = q[3]
    beam_y = q[4]
    beam_theta = q[5]
    beam_q1 = q[6]
    beam_q2 = q[7]
    beam_q3 = q[8]
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
    c139 = c[139]
    c140 = c[140]
    c141 = c[141]
    c142 = c[142]
    c143 = c[143]
    c144 = c[144]
    c145 = c[145]
    c146 = c[146]
    c147 = c[147]
    c148 = c[148]
    c149 = c[149]
    c150 = c[150]
    c151 = c[151]
    c152 = c[152]
    c153 = c[153]
    c154 = c[154]
    c155 = c[155]
    c156 = c[156]
    c157 = c[157]
    c158 = c[158]
    c159 = c[159]
    c160 = c[160]
    c161 = c[161]
    c162 = c[162]
    c163 = c[163]
    c164 = c[164]
    c165 = c[165]
    c166 = c[166]
    c167 = c[167]
    c168 = c[168]
    c169 = c[169]
    c170 = c[170]
    c171 = c[171]
    c172 = c[172]
    c173 = c[173]
    c174 = c[174]
    c175 = c[175]
    c176 = c[176]
    c177 = c[177]
    c178 = c[178]
    c179 = c[179]
    c180 = c[180]
    c181 = c[181]
    c182 = c[182]
    c183 = c[183]
    c184 = c[184]
    c185 = c[185]
    c186 = c[186]
    c187 = c[187]
    c188 = c[188]
    c189 = c[189]
    c190 = c[190]
    c191 = c[191]
    c192 = c[192]
    c193 = c[193]
    c194 = c[194]
    c195 = c[195]
    c196 = c[196]
    c197 = c[197]
    c198 = c[198]
    c199 = c[199]
    c200 = c[200]
    c201 = c[201]
    c202 = c[202]
    c203 = c[203]
    c204 = c[204]
    c205 = c[205]
    c206 = c[206]
    c207 = c[207]
    c208 = c[208]
    c209 = c[209]
    c210 = c[210]
    c211 = c[211]
    c212 = c[212]
    c213 = c[213]
    c214 = c[214]
    c215 = c[215]
    c216 = c[216]
    c217 = c[217]
    c218 = c[218]
    c219 = c[219]
    c220 = c[220]
    c221 = c[221]
    c222 = c[222]
    c223 = c[223]
    c224 = c[224]
    c225 = c[225]
    c226 = c[226]
    c227 = c[227]
    c228 = c[228]
    c229 = c[229]
    c230 = c[230]
    c231 = c[231]
    c232 = c[232]
    c233 = c[233]
    c234 = c[234]
    c235 = c[235]
    c236 = c[236]
    c237 = c[237]
    c238 = c[238]
    c239 = c[239]
    c240 = c[240]
    c241 = c[241]
    c242 = c[242]
    c243 = c[243]
    c244 = c[244]
    w0 = ca.cos(beam_theta)
    w1 = beam_q1 * exaggeration
    w2 = exaggeration * beam_q2
    w3 = exaggeration * beam_q3
    w4 = w1 * (w1 * c51 + w2 * c52 + w3 * c53) + w2 * (w1 * c54 + w2 * c55 + w3 * c56) + w3 * (w1 * c57 + w2 * c58 + w3 * c59)
    w5 = c50 - w4 * 0.5
    w6 = ca.sin(beam_theta)
    w7 = w1 * c60 + w2 * c61 + w3 * c62
    w8 = w1 * (w1 * c64 + w2 * c65 + w3 * c66) + w2 * (w1 * c67 + w2 * c68 + w3 * c69) + w3 * (w1 * c70 + w2 * c71 + w3 * c72)
    w9 = c63 - w8 * 0.5
    w10 = w1 * c73 + w2 * c74 + w3 * c75
    w11 = w1 * (w1 * c77 + w2 * c78 + w3 * c79) + w2 * (w1 * c80 + w2 * c81 + w3 * c82) + w3 * (w1 * c83 + w2 * c84 + w3 * c85)
    w12 = c76 - w11 * 0.5
    w13 = w1 * c86 + w2 * c87 + w3 * c88
    w14 = w1 * (w1 * c90 + w2 * c91 + w3 * c92) + w2 * (w1 * c93 + w2 * c94 + w3 * c95) + w3 * (w1 * c96 + w2 * c97 + w3 * c98)
    w15 = c89 - w14 * 0.5
    w16 = w1 * c99 + w2 * c100 + w3 * c101
    w17 = w1 * (w1 * c103 + w2 * c104 + w3 * c105) + w2 * (w1 * c106 + w2 * c107 + w3 * c108) + w3 * (w1 * c109 + w2 * c110 + w3 * c111)
    w18 = c102 - w17 * 0.5
    w19 = w1 * c112 + w2 * c113 + w3 * c114
    w20 = w1 * (w1 * c116 + w2 * c117 + w3 * c118) + w2 * (w1 * c119 + w2 * c120 + w3 * c121) + w3 * (w1 * c122 + w2 * c123 + w3 * c124)
    w21 = c115 - w20 * 0.5
    w22 = w1 * c125 + w2 * c126 + w3 * c127
    w23 = w1 * (w1 * c129 + w2 * c130 + w3 * c131) + w2 * (w1 * c132 + w2 * c133 + w3 * c134) + w3 * (w1 * c135 + w2 * c136 + w3 * c137)
    w24 = c128 - w23 * 0.5
    w25 = w1 * c138 + w2 * c139 + w3 * c140
    w26 = w1 * (w1 * c142 + w2 * c143 + w3 * c144) + w2 * (w1 * c145 + w2 * c146 + w3 * c147) + w3 * (w1 * c148 + w2 * c149 + w3 * c150)
    w27 = c141 - w26 * 0.5
    w28 = w1 * c151 + w2 * c152 + w3 * c153
    w29 = w1 * (w1 * c155 + w2 * c156 + w3 * c157) + w2 * (w1 * c158 + w2 * c159 + w3 * c160) + w3 * (w1 * c161 + w2 * c162 + w3 * c163)
    w30 = c154 - w29 * 0.5
    w31 = w1 * c164 + w2 * c165 + w3 * c166
    w32 = w1 * (w1 * c168 + w2 * c169 + w3 * c170) + w2 * (w1 * c171 + w2 * c172 + w3 * c173) + w3 * (w1 * c174 + w2 * c175 + w3 * c176)
    w33 = c167 - w32 * 0.5
    w34 = w1 * c177 + w2 * c178 + w3 * c179
    w35 = w1 * (w1 * c181 + w2 * c182 + w3 * c183) + w2 * (w1 * c184 + w2 * c185 + w3 * c186) + w3 * (w1 * c187 + w2 * c188 + w3 * c189)
    w36 = c180 - w35 * 0.5
    w37 = w1 * c190 + w2 * c191 + w3 * c192
    w38 = w1 * (w1 * c194 + w2 * c195 + w3 * c196) + w2 * (w1 * c197 + w2 * c198 + w3 * c199) + w3 * (w1 * c200 + w2 * c201 + w3 * c202)
    w39 = c193 - w38 * 0.5
    w40 = w1 * c203 + w2 * c204 + w3 * c205
    w41 = w1 * (w1 * c207 + w2 * c208 + w3 * c209) + w2 * (w1 * c210 + w2 * c211 + w3 * c212) + w3 * (w1 * c213 + w2 * c214 + w3 * c215)
    w42 = c206 - w41 * 0.5
    w43 = w1 * c216 + w2 * c217 + w3 * c218
    w44 = w1 * (w1 * c220 + w2 * c221 + w3 * c222) + w2 * (w1 * c223 + w2 * c224 + w3 * c225) + w3 * (w1 * c226 + w2 * c227 + w3 * c228)
    w45 = c219 - w44 * 0.5
    w46 = w1 * c229 + w2 * c230 + w3 * c231
    w47 = w1 * (w1 * c233 + w2 * c234 + w3 * c235) + w2 * (w1 * c236 + w2 * c237 + w3 * c238) + w3 * (w1 * c239 + w2 * c240 + w3 * c241)
    w48 = c232 - w47 * 0.5
    w49 = w1 * c242 + w2 * c243 + w3 * c244
    w50 = w1 * (w1 * c38 + w2 * c39 + w3 * c40) + w2 * (w1 * c41 + w2 * c42 + w3 * c43) + w3 * (w1 * c44 + w2 * c45 + w3 * c46)
    w51 = c37 - w50 * 0.5
    w52 = w1 * c47 + w2 * c48 + w3 * c49
    xy = ca.vertcat(
        hub_x,
        hub_y,
        beam_x,
        beam_y,
        beam_x + (w0 * w5 - w6 * w7),
        beam_y + (w5 * w6 + w0 * w7),
        beam_x + (w0 * w9 - w6 * w10),
        beam_y + (w6 * w9 + w0 * w10),
        beam_x + (w0 * w12 - w6 * w13),
        beam_y + (w6 * w12 + w0 * w13),
        beam_x + (w0 * w15 - w6 * w16),
        beam_y + (w6 * w15 + w0 * w16),
        beam_x + (w0 * w18 - w6 * w19),
        beam_y + (w6 * w18 + w0 * w19),
        beam_x + (w0 * w21 - w6 * w22),
        beam_y + (w6 * w21 + w0 * w22),
        beam_x + (w0 * w24 - w6 * w25),
        beam_y + (w6 * w24 + w0 * w25),
        beam_x + (w0 * w27 - w6 * w28),
        beam_y + (w6 * w27 + w0 * w28),
        beam_x + (w0 * w30 - w6 * w31),
        beam_y + (w6 * w30 + w0 * w31),
        beam_x + (w0 * w33 - w6 * w34),
        beam_y + (w6 * w33 + w0 * w34),
        beam_x + (w0 * w36 - w6 * w37),
        beam_y + (w6 * w36 + w0 * w37),
        beam_x + (w0 * w39 - w6 * w40),
        beam_y + (w6 * w39 + w0 * w40),
        beam_x + (w0 * w42 - w6 * w43),
        beam_y + (w6 * w42 + w0 * w43),
        beam_x + (w0 * w45 - w6 * w46),
        beam_y + (w6 * w45 + w0 * w46),
        beam_x + (w0 * w48 - w6 * w49),
        beam_y + (w6 * w48 + w0 * w49),
        beam_x + (w0 * w51 - w6 * w52),
        beam_y + (w6 * w51 + w0 * w52),
    )
    xy = ca.reshape(xy, 2, 18)
    xy = ca.densify(xy)
    inputs, outputs = [q, exaggeration, c], [xy]
    return ca.Function("drawing", inputs, outputs, ["q", "exaggeration", "c"], ["xy"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 72 operations."""
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    c = ca.SX.sym("c", 266)
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
    c2 = c[2]
    c3 = c[3]
    c5 = c[5]
    c7 = c[7]
    c9 = c[9]
    c10 = c[10]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c245 = c[245]
    c246 = c[246]
    c247 = c[247]
    c248 = c[248]
    c249 = c[249]
    c250 = c[250]
    c251 = c[251]
    c252 = c[252]
    c253 = c[253]
    w0 = beam_theta_dot * -2.0
    w1 = beam_theta_dot**2
    dQ_hat_dq_i = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        w0 * (beam_q1_dot * c245 - beam_q2_dot * c5 - beam_q3_dot * c9),
        w1 * c245 - c17,
        w1 * c248,
        w1 * c249,
        w0 * (beam_q2_dot * c246 - beam_q1_dot * c2 - beam_q3_dot * c10),
        w1 * c250,
        w1 * c246 - c18,
        w1 * c251,
        w0 * (beam_q3_dot * c247 - (beam_q1_dot * c3 + beam_q2_dot * c7)),
        w1 * c252,
        w1 * c253,
        w1 * c247 - c19,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 4, 4)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_i_dot, q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 72 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    c = ca.SX.sym("c", 266)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
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
    w0 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w1 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w2 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w3 = 2 * beam_theta_dot
    w4 = beam_theta_dot * -2.0
    dQ_hat_dq_i_dot = ca.vertcat(
        (w0 * beam_q1_dot + w1 * beam_q2_dot + w2 * beam_q3_dot) * -2.0,
        w0 * w3,
        w1 * w3,
        w2 * w3,
        w0 * w4,
        0.0,
        0.0,
        0.0,
        w1 * w4,
        0.0,
        0.0,
        0.0,
        w2 * w4,
        0.0,
        0.0,
        0.0,
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 4, 4)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [q_i, q_i_dot, q_d_dot, c], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, ["q_i", "q_i_dot", "q_d_dot", "c"], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 45 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_ddot = ca.SX.sym("q_i_ddot", 4)
    c = ca.SX.sym("c", 266)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    hub_theta_ddot = q_i_ddot[0]
    c254 = c[254]
    c255 = c[255]
    c256 = c[256]
    c257 = c[257]
    c258 = c[258]
    c259 = c[259]
    w0 = beam_q3 * hub_theta_ddot
    w1 = beam_q2 * hub_theta_ddot
    w2 = beam_q1 * hub_theta_ddot
    dMa_dq_i = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        w2 * c257 - w1 * c254 - w0 * c255,
        0.0,
        0.0,
        0.0,
        w1 * c258 - w2 * c254 - w0 * c256,
        0.0,
        0.0,
        0.0,
        w0 * c259 - w2 * c255 - w1 * c256,
        0.0,
        0.0,
        0.0,
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 4, 4)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [q_i, q_i_ddot, c], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, ["q_i", "q_i_ddot", "c"], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 112 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 266)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
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
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c16 = c[16]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c20 = c[20]
    c22 = c[22]
    c260 = c[260]
    c261 = c[261]
    c262 = c[262]
    c263 = c[263]
    c264 = c[264]
    c265 = c[265]
    w0 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w1 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w2 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w3 = beam_theta_dot**2
    w4 = w2 * w3 - beam_q3 * c19
    w5 = w1 * w3 - beam_q2 * c18
    w6 = beam_theta_dot * -2.0 * (w0 * beam_q1_dot + w1 * beam_q2_dot + w2 * beam_q3_dot) - w4 * c260 - w5 * c261
    w7 = w0 * w3 - beam_q1 * c17
    w8 = (ca.if_else(t < 2.0, ca.sin(t * 3.141592653589793) * c16, 0) + (w6 - w7 * c262)) / (c20 + (c22 + (beam_q1 * w0 + beam_q2 * w1 + beam_q3 * w2) - c263 - c264 - c265))
    q_i_ddot = ca.vertcat(
        w8,
        (w7 - w8 * c13) / c0,
        (w5 - w8 * c14) / c4,
        (w4 - w8 * c15) / c8,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, q_i_dot, q_d_dot, t, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_i_dot", "q_d_dot", "t", "c"], ["q_i_ddot"])


def blocks() -> ca.Function:
    """Blocks of M_hat and Q_hat by the groups of the partition (Eq. 39). 102 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_i_dot = ca.SX.sym("q_i_dot", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 266)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_q1_dot = q_i_dot[1]
    beam_q2_dot = q_i_dot[2]
    beam_q3_dot = q_i_dot[3]
    beam_theta_dot = q_d_dot[4]
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
    w0 = beam_q1 * c0 - (beam_q1 * c1 + beam_q2 * c2 + beam_q3 * c3)
    w1 = beam_q2 * c4 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7)
    w2 = beam_q3 * c8 - (beam_q1 * c9 + beam_q2 * c10 + beam_q3 * c11)
    w3 = ca.if_else(t < 2.0, ca.sin(t * 3.141592653589793) * c16, 0) + beam_theta_dot * -2.0 * (w0 * beam_q1_dot + w1 * beam_q2_dot + w2 * beam_q3_dot)
    w4 = beam_theta_dot**2
    M_hat_LL = ca.vertcat(
        beam_q3 * w2 + (beam_q2 * w1 + (c12 + beam_q1 * w0)),
    )
    M_hat_LL = ca.densify(M_hat_LL)
    M_hat_LS = ca.vertcat(
        c13,
        c14,
        c15,
    )
    M_hat_LS = ca.reshape(M_hat_LS, 1, 3)
    M_hat_LS = ca.densify(M_hat_LS)
    M_hat_SL = ca.vertcat(
        c13,
        c14,
        c15,
    )
    M_hat_SL = ca.densify(M_hat_SL)
    M_hat_SS = ca.vertcat(
        c0,
        0.0,
        0.0,
        0.0,
        c4,
        0.0,
        0.0,
        0.0,
        c8,
    )
    M_hat_SS = ca.reshape(M_hat_SS, 3, 3)
    M_hat_SS = ca.densify(M_hat_SS)
    Q_hat_L = ca.vertcat(
        w3,
    )
    Q_hat_L = ca.densify(Q_hat_L)
    Q_hat_S = ca.vertcat(
        w0 * w4 - beam_q1 * c17,
        w1 * w4 - beam_q2 * c18,
        w2 * w4 - beam_q3 * c19,
    )
    Q_hat_S = ca.densify(Q_hat_S)
    inputs, outputs = [q_i, q_i_dot, q_d_dot, t, c], [M_hat_LL, M_hat_LS, M_hat_SL, M_hat_SS, Q_hat_L, Q_hat_S]
    return ca.Function("blocks", inputs, outputs, ["q_i", "q_i_dot", "q_d_dot", "t", "c"], ["M_hat_LL", "M_hat_LS", "M_hat_SL", "M_hat_SS", "Q_hat_L", "Q_hat_S"])


def substep_2() -> ca.Function:
    """Sub-step: M_hat of the active groups and their right-hand side with slower accelerations given (Eq. 64). 67 operations."""
    q_i = ca.SX.sym("q_i", 4)
    q_d_dot = ca.SX.sym("q_d_dot", 5)
    q_L_ddot = ca.SX.sym("q_L_ddot", 1)
    c = ca.SX.sym("c", 266)
    beam_q1 = q_i[1]
    beam_q2 = q_i[2]
    beam_q3 = q_i[3]
    beam_theta_dot = q_d_dot[4]
    hub_theta_ddot = q_L_ddot[0]
    c0 = c[0]
    c2 = c[2]
    c3 = c[3]
    c4 = c[4]
    c5 = c[5]
    c7 = c[7]
    c8 = c[8]
    c9 = c[9]
    c10 = c[10]
    c13 = c[13]
    c14 = c[14]
    c15 = c[15]
    c17 = c[17]
    c18 = c[18]
    c19 = c[19]
    c245 = c[245]
    c246 = c[246]
    c247 = c[247]
    w0 = beam_theta_dot**2
    w1 = w0 * beam_q1
    w2 = w0 * beam_q2
    w3 = w0 * beam_q3
    M_hat_SS = ca.vertcat(
        c0,
        0.0,
        0.0,
        0.0,
        c4,
        0.0,
        0.0,
        0.0,
        c8,
    )
    M_hat_SS = ca.reshape(M_hat_SS, 3, 3)
    M_hat_SS = ca.densify(M_hat_SS)
    rhs_S = ca.vertcat(
        w1 * c245 - w2 * c2 - w3 * c3 - beam_q1 * c17 - hub_theta_ddot * c13,
        w2 * c246 - w1 * c5 - w3 * c7 - beam_q2 * c18 - hub_theta_ddot * c14,
        w3 * c247 - w1 * c9 - w2 * c10 - beam_q3 * c19 - hub_theta_ddot * c15,
    )
    rhs_S = ca.densify(rhs_S)
    inputs, outputs = [q_i, q_d_dot, q_L_ddot, c], [M_hat_SS, rhs_S]
    return ca.Function("substep_2", inputs, outputs, ["q_i", "q_d_dot", "q_L_ddot", "c"], ["M_hat_SS", "rhs_S"])


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
    "drawing": drawing,
    "dQ_hat_dq_i": dQ_hat_dq_i,
    "dQ_hat_dq_i_dot": dQ_hat_dq_i_dot,
    "dMa_dq_i": dMa_dq_i,
    "forward_dynamics": forward_dynamics,
    "blocks": blocks,
    "substep_2": substep_2,
}
