"""Spin-up of a rotating beam (F3): equations of motion, emitted by symgen from the scene `spin_up_beam`.

Do not edit: change the scene and run `symgen generate`. model.md says what was modelled.
"""

import casadi as ca


def constants() -> ca.Function:
    """c: everything that depends on the parameters p only. 1705 operations."""
    p = ca.SX.sym("p", 654)
    omega = p[0]
    ramp = p[1]
    beam_length = p[2]
    beam_density = p[3]
    beam_area = p[4]
    beam_youngs_modulus = p[5]
    beam_second_moment = p[6]
    beam200_clamped_free5_kappa_lateral_0_0 = p[7]
    beam200_clamped_free5_kappa_lateral_1_1 = p[8]
    beam200_clamped_free5_kappa_lateral_2_2 = p[9]
    beam200_clamped_free5_kappa_lateral_3_3 = p[10]
    beam200_clamped_free5_kappa_lateral_4_4 = p[11]
    beam200_clamped_free5_mass_0_0 = p[12]
    beam200_clamped_free5_mass_1_1 = p[13]
    beam200_clamped_free5_mass_2_2 = p[14]
    beam200_clamped_free5_mass_3_3 = p[15]
    beam200_clamped_free5_mass_4_4 = p[16]
    beam200_clamped_free5_s1_0_0 = p[17]
    beam200_clamped_free5_i0_0_0 = p[18]
    beam200_clamped_free5_phi_y_0_0 = p[19]
    beam200_clamped_free5_phi_y_1_0 = p[20]
    beam200_clamped_free5_phi_y_2_0 = p[21]
    beam200_clamped_free5_phi_y_3_0 = p[22]
    beam200_clamped_free5_phi_y_4_0 = p[23]
    beam200_clamped_free5_xi_phi_y_0_0 = p[24]
    beam200_clamped_free5_xi_phi_y_1_0 = p[25]
    beam200_clamped_free5_xi_phi_y_2_0 = p[26]
    beam200_clamped_free5_xi_phi_y_3_0 = p[27]
    beam200_clamped_free5_xi_phi_y_4_0 = p[28]
    beam200_clamped_free5_H_0_0 = p[29]
    beam200_clamped_free5_H_0_1 = p[30]
    beam200_clamped_free5_H_0_2 = p[31]
    beam200_clamped_free5_H_0_3 = p[32]
    beam200_clamped_free5_H_0_4 = p[33]
    beam200_clamped_free5_H_1_0 = p[34]
    beam200_clamped_free5_H_1_1 = p[35]
    beam200_clamped_free5_H_1_2 = p[36]
    beam200_clamped_free5_H_1_3 = p[37]
    beam200_clamped_free5_H_1_4 = p[38]
    beam200_clamped_free5_H_2_0 = p[39]
    beam200_clamped_free5_H_2_1 = p[40]
    beam200_clamped_free5_H_2_2 = p[41]
    beam200_clamped_free5_H_2_3 = p[42]
    beam200_clamped_free5_H_2_4 = p[43]
    beam200_clamped_free5_H_3_0 = p[44]
    beam200_clamped_free5_H_3_1 = p[45]
    beam200_clamped_free5_H_3_2 = p[46]
    beam200_clamped_free5_H_3_3 = p[47]
    beam200_clamped_free5_H_3_4 = p[48]
    beam200_clamped_free5_H_4_0 = p[49]
    beam200_clamped_free5_H_4_1 = p[50]
    beam200_clamped_free5_H_4_2 = p[51]
    beam200_clamped_free5_H_4_3 = p[52]
    beam200_clamped_free5_H_4_4 = p[53]
    beam200_clamped_free5_xH_0_0 = p[54]
    beam200_clamped_free5_xH_0_1 = p[55]
    beam200_clamped_free5_xH_0_2 = p[56]
    beam200_clamped_free5_xH_0_3 = p[57]
    beam200_clamped_free5_xH_0_4 = p[58]
    beam200_clamped_free5_xH_1_0 = p[59]
    beam200_clamped_free5_xH_1_1 = p[60]
    beam200_clamped_free5_xH_1_2 = p[61]
    beam200_clamped_free5_xH_1_3 = p[62]
    beam200_clamped_free5_xH_1_4 = p[63]
    beam200_clamped_free5_xH_2_0 = p[64]
    beam200_clamped_free5_xH_2_1 = p[65]
    beam200_clamped_free5_xH_2_2 = p[66]
    beam200_clamped_free5_xH_2_3 = p[67]
    beam200_clamped_free5_xH_2_4 = p[68]
    beam200_clamped_free5_xH_3_0 = p[69]
    beam200_clamped_free5_xH_3_1 = p[70]
    beam200_clamped_free5_xH_3_2 = p[71]
    beam200_clamped_free5_xH_3_3 = p[72]
    beam200_clamped_free5_xH_3_4 = p[73]
    beam200_clamped_free5_xH_4_0 = p[74]
    beam200_clamped_free5_xH_4_1 = p[75]
    beam200_clamped_free5_xH_4_2 = p[76]
    beam200_clamped_free5_xH_4_3 = p[77]
    beam200_clamped_free5_xH_4_4 = p[78]
    beam200_clamped_free5_1_0_shape_1_0 = p[79]
    beam200_clamped_free5_1_0_shape_1_1 = p[80]
    beam200_clamped_free5_1_0_shape_1_2 = p[81]
    beam200_clamped_free5_1_0_shape_1_3 = p[82]
    beam200_clamped_free5_1_0_shape_1_4 = p[83]
    beam200_clamped_free5_1_0_H_0_0 = p[89]
    beam200_clamped_free5_1_0_H_0_1 = p[90]
    beam200_clamped_free5_1_0_H_0_2 = p[91]
    beam200_clamped_free5_1_0_H_0_3 = p[92]
    beam200_clamped_free5_1_0_H_0_4 = p[93]
    beam200_clamped_free5_1_0_H_1_0 = p[94]
    beam200_clamped_free5_1_0_H_1_1 = p[95]
    beam200_clamped_free5_1_0_H_1_2 = p[96]
    beam200_clamped_free5_1_0_H_1_3 = p[97]
    beam200_clamped_free5_1_0_H_1_4 = p[98]
    beam200_clamped_free5_1_0_H_2_0 = p[99]
    beam200_clamped_free5_1_0_H_2_1 = p[100]
    beam200_clamped_free5_1_0_H_2_2 = p[101]
    beam200_clamped_free5_1_0_H_2_3 = p[102]
    beam200_clamped_free5_1_0_H_2_4 = p[103]
    beam200_clamped_free5_1_0_H_3_0 = p[104]
    beam200_clamped_free5_1_0_H_3_1 = p[105]
    beam200_clamped_free5_1_0_H_3_2 = p[106]
    beam200_clamped_free5_1_0_H_3_3 = p[107]
    beam200_clamped_free5_1_0_H_3_4 = p[108]
    beam200_clamped_free5_1_0_H_4_0 = p[109]
    beam200_clamped_free5_1_0_H_4_1 = p[110]
    beam200_clamped_free5_1_0_H_4_2 = p[111]
    beam200_clamped_free5_1_0_H_4_3 = p[112]
    beam200_clamped_free5_1_0_H_4_4 = p[113]
    beam200_clamped_free5_0_0625_at_0_0 = p[114]
    beam200_clamped_free5_0_0625_shape_1_0 = p[115]
    beam200_clamped_free5_0_0625_shape_1_1 = p[116]
    beam200_clamped_free5_0_0625_shape_1_2 = p[117]
    beam200_clamped_free5_0_0625_shape_1_3 = p[118]
    beam200_clamped_free5_0_0625_shape_1_4 = p[119]
    beam200_clamped_free5_0_0625_H_0_0 = p[125]
    beam200_clamped_free5_0_0625_H_0_1 = p[126]
    beam200_clamped_free5_0_0625_H_0_2 = p[127]
    beam200_clamped_free5_0_0625_H_0_3 = p[128]
    beam200_clamped_free5_0_0625_H_0_4 = p[129]
    beam200_clamped_free5_0_0625_H_1_0 = p[130]
    beam200_clamped_free5_0_0625_H_1_1 = p[131]
    beam200_clamped_free5_0_0625_H_1_2 = p[132]
    beam200_clamped_free5_0_0625_H_1_3 = p[133]
    beam200_clamped_free5_0_0625_H_1_4 = p[134]
    beam200_clamped_free5_0_0625_H_2_0 = p[135]
    beam200_clamped_free5_0_0625_H_2_1 = p[136]
    beam200_clamped_free5_0_0625_H_2_2 = p[137]
    beam200_clamped_free5_0_0625_H_2_3 = p[138]
    beam200_clamped_free5_0_0625_H_2_4 = p[139]
    beam200_clamped_free5_0_0625_H_3_0 = p[140]
    beam200_clamped_free5_0_0625_H_3_1 = p[141]
    beam200_clamped_free5_0_0625_H_3_2 = p[142]
    beam200_clamped_free5_0_0625_H_3_3 = p[143]
    beam200_clamped_free5_0_0625_H_3_4 = p[144]
    beam200_clamped_free5_0_0625_H_4_0 = p[145]
    beam200_clamped_free5_0_0625_H_4_1 = p[146]
    beam200_clamped_free5_0_0625_H_4_2 = p[147]
    beam200_clamped_free5_0_0625_H_4_3 = p[148]
    beam200_clamped_free5_0_0625_H_4_4 = p[149]
    beam200_clamped_free5_0_125_at_0_0 = p[150]
    beam200_clamped_free5_0_125_shape_1_0 = p[151]
    beam200_clamped_free5_0_125_shape_1_1 = p[152]
    beam200_clamped_free5_0_125_shape_1_2 = p[153]
    beam200_clamped_free5_0_125_shape_1_3 = p[154]
    beam200_clamped_free5_0_125_shape_1_4 = p[155]
    beam200_clamped_free5_0_125_H_0_0 = p[161]
    beam200_clamped_free5_0_125_H_0_1 = p[162]
    beam200_clamped_free5_0_125_H_0_2 = p[163]
    beam200_clamped_free5_0_125_H_0_3 = p[164]
    beam200_clamped_free5_0_125_H_0_4 = p[165]
    beam200_clamped_free5_0_125_H_1_0 = p[166]
    beam200_clamped_free5_0_125_H_1_1 = p[167]
    beam200_clamped_free5_0_125_H_1_2 = p[168]
    beam200_clamped_free5_0_125_H_1_3 = p[169]
    beam200_clamped_free5_0_125_H_1_4 = p[170]
    beam200_clamped_free5_0_125_H_2_0 = p[171]
    beam200_clamped_free5_0_125_H_2_1 = p[172]
    beam200_clamped_free5_0_125_H_2_2 = p[173]
    beam200_clamped_free5_0_125_H_2_3 = p[174]
    beam200_clamped_free5_0_125_H_2_4 = p[175]
    beam200_clamped_free5_0_125_H_3_0 = p[176]
    beam200_clamped_free5_0_125_H_3_1 = p[177]
    beam200_clamped_free5_0_125_H_3_2 = p[178]
    beam200_clamped_free5_0_125_H_3_3 = p[179]
    beam200_clamped_free5_0_125_H_3_4 = p[180]
    beam200_clamped_free5_0_125_H_4_0 = p[181]
    beam200_clamped_free5_0_125_H_4_1 = p[182]
    beam200_clamped_free5_0_125_H_4_2 = p[183]
    beam200_clamped_free5_0_125_H_4_3 = p[184]
    beam200_clamped_free5_0_125_H_4_4 = p[185]
    beam200_clamped_free5_0_1875_at_0_0 = p[186]
    beam200_clamped_free5_0_1875_shape_1_0 = p[187]
    beam200_clamped_free5_0_1875_shape_1_1 = p[188]
    beam200_clamped_free5_0_1875_shape_1_2 = p[189]
    beam200_clamped_free5_0_1875_shape_1_3 = p[190]
    beam200_clamped_free5_0_1875_shape_1_4 = p[191]
    beam200_clamped_free5_0_1875_H_0_0 = p[197]
    beam200_clamped_free5_0_1875_H_0_1 = p[198]
    beam200_clamped_free5_0_1875_H_0_2 = p[199]
    beam200_clamped_free5_0_1875_H_0_3 = p[200]
    beam200_clamped_free5_0_1875_H_0_4 = p[201]
    beam200_clamped_free5_0_1875_H_1_0 = p[202]
    beam200_clamped_free5_0_1875_H_1_1 = p[203]
    beam200_clamped_free5_0_1875_H_1_2 = p[204]
    beam200_clamped_free5_0_1875_H_1_3 = p[205]
    beam200_clamped_free5_0_1875_H_1_4 = p[206]
    beam200_clamped_free5_0_1875_H_2_0 = p[207]
    beam200_clamped_free5_0_1875_H_2_1 = p[208]
    beam200_clamped_free5_0_1875_H_2_2 = p[209]
    beam200_clamped_free5_0_1875_H_2_3 = p[210]
    beam200_clamped_free5_0_1875_H_2_4 = p[211]
    beam200_clamped_free5_0_1875_H_3_0 = p[212]
    beam200_clamped_free5_0_1875_H_3_1 = p[213]
    beam200_clamped_free5_0_1875_H_3_2 = p[214]
    beam200_clamped_free5_0_1875_H_3_3 = p[215]
    beam200_clamped_free5_0_1875_H_3_4 = p[216]
    beam200_clamped_free5_0_1875_H_4_0 = p[217]
    beam200_clamped_free5_0_1875_H_4_1 = p[218]
    beam200_clamped_free5_0_1875_H_4_2 = p[219]
    beam200_clamped_free5_0_1875_H_4_3 = p[220]
    beam200_clamped_free5_0_1875_H_4_4 = p[221]
    beam200_clamped_free5_0_25_at_0_0 = p[222]
    beam200_clamped_free5_0_25_shape_1_0 = p[223]
    beam200_clamped_free5_0_25_shape_1_1 = p[224]
    beam200_clamped_free5_0_25_shape_1_2 = p[225]
    beam200_clamped_free5_0_25_shape_1_3 = p[226]
    beam200_clamped_free5_0_25_shape_1_4 = p[227]
    beam200_clamped_free5_0_25_H_0_0 = p[233]
    beam200_clamped_free5_0_25_H_0_1 = p[234]
    beam200_clamped_free5_0_25_H_0_2 = p[235]
    beam200_clamped_free5_0_25_H_0_3 = p[236]
    beam200_clamped_free5_0_25_H_0_4 = p[237]
    beam200_clamped_free5_0_25_H_1_0 = p[238]
    beam200_clamped_free5_0_25_H_1_1 = p[239]
    beam200_clamped_free5_0_25_H_1_2 = p[240]
    beam200_clamped_free5_0_25_H_1_3 = p[241]
    beam200_clamped_free5_0_25_H_1_4 = p[242]
    beam200_clamped_free5_0_25_H_2_0 = p[243]
    beam200_clamped_free5_0_25_H_2_1 = p[244]
    beam200_clamped_free5_0_25_H_2_2 = p[245]
    beam200_clamped_free5_0_25_H_2_3 = p[246]
    beam200_clamped_free5_0_25_H_2_4 = p[247]
    beam200_clamped_free5_0_25_H_3_0 = p[248]
    beam200_clamped_free5_0_25_H_3_1 = p[249]
    beam200_clamped_free5_0_25_H_3_2 = p[250]
    beam200_clamped_free5_0_25_H_3_3 = p[251]
    beam200_clamped_free5_0_25_H_3_4 = p[252]
    beam200_clamped_free5_0_25_H_4_0 = p[253]
    beam200_clamped_free5_0_25_H_4_1 = p[254]
    beam200_clamped_free5_0_25_H_4_2 = p[255]
    beam200_clamped_free5_0_25_H_4_3 = p[256]
    beam200_clamped_free5_0_25_H_4_4 = p[257]
    beam200_clamped_free5_0_3125_at_0_0 = p[258]
    beam200_clamped_free5_0_3125_shape_1_0 = p[259]
    beam200_clamped_free5_0_3125_shape_1_1 = p[260]
    beam200_clamped_free5_0_3125_shape_1_2 = p[261]
    beam200_clamped_free5_0_3125_shape_1_3 = p[262]
    beam200_clamped_free5_0_3125_shape_1_4 = p[263]
    beam200_clamped_free5_0_3125_H_0_0 = p[269]
    beam200_clamped_free5_0_3125_H_0_1 = p[270]
    beam200_clamped_free5_0_3125_H_0_2 = p[271]
    beam200_clamped_free5_0_3125_H_0_3 = p[272]
    beam200_clamped_free5_0_3125_H_0_4 = p[273]
    beam200_clamped_free5_0_3125_H_1_0 = p[274]
    beam200_clamped_free5_0_3125_H_1_1 = p[275]
    beam200_clamped_free5_0_3125_H_1_2 = p[276]
    beam200_clamped_free5_0_3125_H_1_3 = p[277]
    beam200_clamped_free5_0_3125_H_1_4 = p[278]
    beam200_clamped_free5_0_3125_H_2_0 = p[279]
    beam200_clamped_free5_0_3125_H_2_1 = p[280]
    beam200_clamped_free5_0_3125_H_2_2 = p[281]
    beam200_clamped_free5_0_3125_H_2_3 = p[282]
    beam200_clamped_free5_0_3125_H_2_4 = p[283]
    beam200_clamped_free5_0_3125_H_3_0 = p[284]
    beam200_clamped_free5_0_3125_H_3_1 = p[285]
    beam200_clamped_free5_0_3125_H_3_2 = p[286]
    beam200_clamped_free5_0_3125_H_3_3 = p[287]
    beam200_clamped_free5_0_3125_H_3_4 = p[288]
    beam200_clamped_free5_0_3125_H_4_0 = p[289]
    beam200_clamped_free5_0_3125_H_4_1 = p[290]
    beam200_clamped_free5_0_3125_H_4_2 = p[291]
    beam200_clamped_free5_0_3125_H_4_3 = p[292]
    beam200_clamped_free5_0_3125_H_4_4 = p[293]
    beam200_clamped_free5_0_375_at_0_0 = p[294]
    beam200_clamped_free5_0_375_shape_1_0 = p[295]
    beam200_clamped_free5_0_375_shape_1_1 = p[296]
    beam200_clamped_free5_0_375_shape_1_2 = p[297]
    beam200_clamped_free5_0_375_shape_1_3 = p[298]
    beam200_clamped_free5_0_375_shape_1_4 = p[299]
    beam200_clamped_free5_0_375_H_0_0 = p[305]
    beam200_clamped_free5_0_375_H_0_1 = p[306]
    beam200_clamped_free5_0_375_H_0_2 = p[307]
    beam200_clamped_free5_0_375_H_0_3 = p[308]
    beam200_clamped_free5_0_375_H_0_4 = p[309]
    beam200_clamped_free5_0_375_H_1_0 = p[310]
    beam200_clamped_free5_0_375_H_1_1 = p[311]
    beam200_clamped_free5_0_375_H_1_2 = p[312]
    beam200_clamped_free5_0_375_H_1_3 = p[313]
    beam200_clamped_free5_0_375_H_1_4 = p[314]
    beam200_clamped_free5_0_375_H_2_0 = p[315]
    beam200_clamped_free5_0_375_H_2_1 = p[316]
    beam200_clamped_free5_0_375_H_2_2 = p[317]
    beam200_clamped_free5_0_375_H_2_3 = p[318]
    beam200_clamped_free5_0_375_H_2_4 = p[319]
    beam200_clamped_free5_0_375_H_3_0 = p[320]
    beam200_clamped_free5_0_375_H_3_1 = p[321]
    beam200_clamped_free5_0_375_H_3_2 = p[322]
    beam200_clamped_free5_0_375_H_3_3 = p[323]
    beam200_clamped_free5_0_375_H_3_4 = p[324]
    beam200_clamped_free5_0_375_H_4_0 = p[325]
    beam200_clamped_free5_0_375_H_4_1 = p[326]
    beam200_clamped_free5_0_375_H_4_2 = p[327]
    beam200_clamped_free5_0_375_H_4_3 = p[328]
    beam200_clamped_free5_0_375_H_4_4 = p[329]
    beam200_clamped_free5_0_4375_at_0_0 = p[330]
    beam200_clamped_free5_0_4375_shape_1_0 = p[331]
    beam200_clamped_free5_0_4375_shape_1_1 = p[332]
    beam200_clamped_free5_0_4375_shape_1_2 = p[333]
    beam200_clamped_free5_0_4375_shape_1_3 = p[334]
    beam200_clamped_free5_0_4375_shape_1_4 = p[335]
    beam200_clamped_free5_0_4375_H_0_0 = p[341]
    beam200_clamped_free5_0_4375_H_0_1 = p[342]
    beam200_clamped_free5_0_4375_H_0_2 = p[343]
    beam200_clamped_free5_0_4375_H_0_3 = p[344]
    beam200_clamped_free5_0_4375_H_0_4 = p[345]
    beam200_clamped_free5_0_4375_H_1_0 = p[346]
    beam200_clamped_free5_0_4375_H_1_1 = p[347]
    beam200_clamped_free5_0_4375_H_1_2 = p[348]
    beam200_clamped_free5_0_4375_H_1_3 = p[349]
    beam200_clamped_free5_0_4375_H_1_4 = p[350]
    beam200_clamped_free5_0_4375_H_2_0 = p[351]
    beam200_clamped_free5_0_4375_H_2_1 = p[352]
    beam200_clamped_free5_0_4375_H_2_2 = p[353]
    beam200_clamped_free5_0_4375_H_2_3 = p[354]
    beam200_clamped_free5_0_4375_H_2_4 = p[355]
    beam200_clamped_free5_0_4375_H_3_0 = p[356]
    beam200_clamped_free5_0_4375_H_3_1 = p[357]
    beam200_clamped_free5_0_4375_H_3_2 = p[358]
    beam200_clamped_free5_0_4375_H_3_3 = p[359]
    beam200_clamped_free5_0_4375_H_3_4 = p[360]
    beam200_clamped_free5_0_4375_H_4_0 = p[361]
    beam200_clamped_free5_0_4375_H_4_1 = p[362]
    beam200_clamped_free5_0_4375_H_4_2 = p[363]
    beam200_clamped_free5_0_4375_H_4_3 = p[364]
    beam200_clamped_free5_0_4375_H_4_4 = p[365]
    beam200_clamped_free5_0_5_at_0_0 = p[366]
    beam200_clamped_free5_0_5_shape_1_0 = p[367]
    beam200_clamped_free5_0_5_shape_1_1 = p[368]
    beam200_clamped_free5_0_5_shape_1_2 = p[369]
    beam200_clamped_free5_0_5_shape_1_3 = p[370]
    beam200_clamped_free5_0_5_shape_1_4 = p[371]
    beam200_clamped_free5_0_5_H_0_0 = p[377]
    beam200_clamped_free5_0_5_H_0_1 = p[378]
    beam200_clamped_free5_0_5_H_0_2 = p[379]
    beam200_clamped_free5_0_5_H_0_3 = p[380]
    beam200_clamped_free5_0_5_H_0_4 = p[381]
    beam200_clamped_free5_0_5_H_1_0 = p[382]
    beam200_clamped_free5_0_5_H_1_1 = p[383]
    beam200_clamped_free5_0_5_H_1_2 = p[384]
    beam200_clamped_free5_0_5_H_1_3 = p[385]
    beam200_clamped_free5_0_5_H_1_4 = p[386]
    beam200_clamped_free5_0_5_H_2_0 = p[387]
    beam200_clamped_free5_0_5_H_2_1 = p[388]
    beam200_clamped_free5_0_5_H_2_2 = p[389]
    beam200_clamped_free5_0_5_H_2_3 = p[390]
    beam200_clamped_free5_0_5_H_2_4 = p[391]
    beam200_clamped_free5_0_5_H_3_0 = p[392]
    beam200_clamped_free5_0_5_H_3_1 = p[393]
    beam200_clamped_free5_0_5_H_3_2 = p[394]
    beam200_clamped_free5_0_5_H_3_3 = p[395]
    beam200_clamped_free5_0_5_H_3_4 = p[396]
    beam200_clamped_free5_0_5_H_4_0 = p[397]
    beam200_clamped_free5_0_5_H_4_1 = p[398]
    beam200_clamped_free5_0_5_H_4_2 = p[399]
    beam200_clamped_free5_0_5_H_4_3 = p[400]
    beam200_clamped_free5_0_5_H_4_4 = p[401]
    beam200_clamped_free5_0_5625_at_0_0 = p[402]
    beam200_clamped_free5_0_5625_shape_1_0 = p[403]
    beam200_clamped_free5_0_5625_shape_1_1 = p[404]
    beam200_clamped_free5_0_5625_shape_1_2 = p[405]
    beam200_clamped_free5_0_5625_shape_1_3 = p[406]
    beam200_clamped_free5_0_5625_shape_1_4 = p[407]
    beam200_clamped_free5_0_5625_H_0_0 = p[413]
    beam200_clamped_free5_0_5625_H_0_1 = p[414]
    beam200_clamped_free5_0_5625_H_0_2 = p[415]
    beam200_clamped_free5_0_5625_H_0_3 = p[416]
    beam200_clamped_free5_0_5625_H_0_4 = p[417]
    beam200_clamped_free5_0_5625_H_1_0 = p[418]
    beam200_clamped_free5_0_5625_H_1_1 = p[419]
    beam200_clamped_free5_0_5625_H_1_2 = p[420]
    beam200_clamped_free5_0_5625_H_1_3 = p[421]
    beam200_clamped_free5_0_5625_H_1_4 = p[422]
    beam200_clamped_free5_0_5625_H_2_0 = p[423]
    beam200_clamped_free5_0_5625_H_2_1 = p[424]
    beam200_clamped_free5_0_5625_H_2_2 = p[425]
    beam200_clamped_free5_0_5625_H_2_3 = p[426]
    beam200_clamped_free5_0_5625_H_2_4 = p[427]
    beam200_clamped_free5_0_5625_H_3_0 = p[428]
    beam200_clamped_free5_0_5625_H_3_1 = p[429]
    beam200_clamped_free5_0_5625_H_3_2 = p[430]
    beam200_clamped_free5_0_5625_H_3_3 = p[431]
    beam200_clamped_free5_0_5625_H_3_4 = p[432]
    beam200_clamped_free5_0_5625_H_4_0 = p[433]
    beam200_clamped_free5_0_5625_H_4_1 = p[434]
    beam200_clamped_free5_0_5625_H_4_2 = p[435]
    beam200_clamped_free5_0_5625_H_4_3 = p[436]
    beam200_clamped_free5_0_5625_H_4_4 = p[437]
    beam200_clamped_free5_0_625_at_0_0 = p[438]
    beam200_clamped_free5_0_625_shape_1_0 = p[439]
    beam200_clamped_free5_0_625_shape_1_1 = p[440]
    beam200_clamped_free5_0_625_shape_1_2 = p[441]
    beam200_clamped_free5_0_625_shape_1_3 = p[442]
    beam200_clamped_free5_0_625_shape_1_4 = p[443]
    beam200_clamped_free5_0_625_H_0_0 = p[449]
    beam200_clamped_free5_0_625_H_0_1 = p[450]
    beam200_clamped_free5_0_625_H_0_2 = p[451]
    beam200_clamped_free5_0_625_H_0_3 = p[452]
    beam200_clamped_free5_0_625_H_0_4 = p[453]
    beam200_clamped_free5_0_625_H_1_0 = p[454]
    beam200_clamped_free5_0_625_H_1_1 = p[455]
    beam200_clamped_free5_0_625_H_1_2 = p[456]
    beam200_clamped_free5_0_625_H_1_3 = p[457]
    beam200_clamped_free5_0_625_H_1_4 = p[458]
    beam200_clamped_free5_0_625_H_2_0 = p[459]
    beam200_clamped_free5_0_625_H_2_1 = p[460]
    beam200_clamped_free5_0_625_H_2_2 = p[461]
    beam200_clamped_free5_0_625_H_2_3 = p[462]
    beam200_clamped_free5_0_625_H_2_4 = p[463]
    beam200_clamped_free5_0_625_H_3_0 = p[464]
    beam200_clamped_free5_0_625_H_3_1 = p[465]
    beam200_clamped_free5_0_625_H_3_2 = p[466]
    beam200_clamped_free5_0_625_H_3_3 = p[467]
    beam200_clamped_free5_0_625_H_3_4 = p[468]
    beam200_clamped_free5_0_625_H_4_0 = p[469]
    beam200_clamped_free5_0_625_H_4_1 = p[470]
    beam200_clamped_free5_0_625_H_4_2 = p[471]
    beam200_clamped_free5_0_625_H_4_3 = p[472]
    beam200_clamped_free5_0_625_H_4_4 = p[473]
    beam200_clamped_free5_0_6875_at_0_0 = p[474]
    beam200_clamped_free5_0_6875_shape_1_0 = p[475]
    beam200_clamped_free5_0_6875_shape_1_1 = p[476]
    beam200_clamped_free5_0_6875_shape_1_2 = p[477]
    beam200_clamped_free5_0_6875_shape_1_3 = p[478]
    beam200_clamped_free5_0_6875_shape_1_4 = p[479]
    beam200_clamped_free5_0_6875_H_0_0 = p[485]
    beam200_clamped_free5_0_6875_H_0_1 = p[486]
    beam200_clamped_free5_0_6875_H_0_2 = p[487]
    beam200_clamped_free5_0_6875_H_0_3 = p[488]
    beam200_clamped_free5_0_6875_H_0_4 = p[489]
    beam200_clamped_free5_0_6875_H_1_0 = p[490]
    beam200_clamped_free5_0_6875_H_1_1 = p[491]
    beam200_clamped_free5_0_6875_H_1_2 = p[492]
    beam200_clamped_free5_0_6875_H_1_3 = p[493]
    beam200_clamped_free5_0_6875_H_1_4 = p[494]
    beam200_clamped_free5_0_6875_H_2_0 = p[495]
    beam200_clamped_free5_0_6875_H_2_1 = p[496]
    beam200_clamped_free5_0_6875_H_2_2 = p[497]
    beam200_clamped_free5_0_6875_H_2_3 = p[498]
    beam200_clamped_free5_0_6875_H_2_4 = p[499]
    beam200_clamped_free5_0_6875_H_3_0 = p[500]
    beam200_clamped_free5_0_6875_H_3_1 = p[501]
    beam200_clamped_free5_0_6875_H_3_2 = p[502]
    beam200_clamped_free5_0_6875_H_3_3 = p[503]
    beam200_clamped_free5_0_6875_H_3_4 = p[504]
    beam200_clamped_free5_0_6875_H_4_0 = p[505]
    beam200_clamped_free5_0_6875_H_4_1 = p[506]
    beam200_clamped_free5_0_6875_H_4_2 = p[507]
    beam200_clamped_free5_0_6875_H_4_3 = p[508]
    beam200_clamped_free5_0_6875_H_4_4 = p[509]
    beam200_clamped_free5_0_75_at_0_0 = p[510]
    beam200_clamped_free5_0_75_shape_1_0 = p[511]
    beam200_clamped_free5_0_75_shape_1_1 = p[512]
    beam200_clamped_free5_0_75_shape_1_2 = p[513]
    beam200_clamped_free5_0_75_shape_1_3 = p[514]
    beam200_clamped_free5_0_75_shape_1_4 = p[515]
    beam200_clamped_free5_0_75_H_0_0 = p[521]
    beam200_clamped_free5_0_75_H_0_1 = p[522]
    beam200_clamped_free5_0_75_H_0_2 = p[523]
    beam200_clamped_free5_0_75_H_0_3 = p[524]
    beam200_clamped_free5_0_75_H_0_4 = p[525]
    beam200_clamped_free5_0_75_H_1_0 = p[526]
    beam200_clamped_free5_0_75_H_1_1 = p[527]
    beam200_clamped_free5_0_75_H_1_2 = p[528]
    beam200_clamped_free5_0_75_H_1_3 = p[529]
    beam200_clamped_free5_0_75_H_1_4 = p[530]
    beam200_clamped_free5_0_75_H_2_0 = p[531]
    beam200_clamped_free5_0_75_H_2_1 = p[532]
    beam200_clamped_free5_0_75_H_2_2 = p[533]
    beam200_clamped_free5_0_75_H_2_3 = p[534]
    beam200_clamped_free5_0_75_H_2_4 = p[535]
    beam200_clamped_free5_0_75_H_3_0 = p[536]
    beam200_clamped_free5_0_75_H_3_1 = p[537]
    beam200_clamped_free5_0_75_H_3_2 = p[538]
    beam200_clamped_free5_0_75_H_3_3 = p[539]
    beam200_clamped_free5_0_75_H_3_4 = p[540]
    beam200_clamped_free5_0_75_H_4_0 = p[541]
    beam200_clamped_free5_0_75_H_4_1 = p[542]
    beam200_clamped_free5_0_75_H_4_2 = p[543]
    beam200_clamped_free5_0_75_H_4_3 = p[544]
    beam200_clamped_free5_0_75_H_4_4 = p[545]
    beam200_clamped_free5_0_8125_at_0_0 = p[546]
    beam200_clamped_free5_0_8125_shape_1_0 = p[547]
    beam200_clamped_free5_0_8125_shape_1_1 = p[548]
    beam200_clamped_free5_0_8125_shape_1_2 = p[549]
    beam200_clamped_free5_0_8125_shape_1_3 = p[550]
    beam200_clamped_free5_0_8125_shape_1_4 = p[551]
    beam200_clamped_free5_0_8125_H_0_0 = p[557]
    beam200_clamped_free5_0_8125_H_0_1 = p[558]
    beam200_clamped_free5_0_8125_H_0_2 = p[559]
    beam200_clamped_free5_0_8125_H_0_3 = p[560]
    beam200_clamped_free5_0_8125_H_0_4 = p[561]
    beam200_clamped_free5_0_8125_H_1_0 = p[562]
    beam200_clamped_free5_0_8125_H_1_1 = p[563]
    beam200_clamped_free5_0_8125_H_1_2 = p[564]
    beam200_clamped_free5_0_8125_H_1_3 = p[565]
    beam200_clamped_free5_0_8125_H_1_4 = p[566]
    beam200_clamped_free5_0_8125_H_2_0 = p[567]
    beam200_clamped_free5_0_8125_H_2_1 = p[568]
    beam200_clamped_free5_0_8125_H_2_2 = p[569]
    beam200_clamped_free5_0_8125_H_2_3 = p[570]
    beam200_clamped_free5_0_8125_H_2_4 = p[571]
    beam200_clamped_free5_0_8125_H_3_0 = p[572]
    beam200_clamped_free5_0_8125_H_3_1 = p[573]
    beam200_clamped_free5_0_8125_H_3_2 = p[574]
    beam200_clamped_free5_0_8125_H_3_3 = p[575]
    beam200_clamped_free5_0_8125_H_3_4 = p[576]
    beam200_clamped_free5_0_8125_H_4_0 = p[577]
    beam200_clamped_free5_0_8125_H_4_1 = p[578]
    beam200_clamped_free5_0_8125_H_4_2 = p[579]
    beam200_clamped_free5_0_8125_H_4_3 = p[580]
    beam200_clamped_free5_0_8125_H_4_4 = p[581]
    beam200_clamped_free5_0_875_at_0_0 = p[582]
    beam200_clamped_free5_0_875_shape_1_0 = p[583]
    beam200_clamped_free5_0_875_shape_1_1 = p[584]
    beam200_clamped_free5_0_875_shape_1_2 = p[585]
    beam200_clamped_free5_0_875_shape_1_3 = p[586]
    beam200_clamped_free5_0_875_shape_1_4 = p[587]
    beam200_clamped_free5_0_875_H_0_0 = p[593]
    beam200_clamped_free5_0_875_H_0_1 = p[594]
    beam200_clamped_free5_0_875_H_0_2 = p[595]
    beam200_clamped_free5_0_875_H_0_3 = p[596]
    beam200_clamped_free5_0_875_H_0_4 = p[597]
    beam200_clamped_free5_0_875_H_1_0 = p[598]
    beam200_clamped_free5_0_875_H_1_1 = p[599]
    beam200_clamped_free5_0_875_H_1_2 = p[600]
    beam200_clamped_free5_0_875_H_1_3 = p[601]
    beam200_clamped_free5_0_875_H_1_4 = p[602]
    beam200_clamped_free5_0_875_H_2_0 = p[603]
    beam200_clamped_free5_0_875_H_2_1 = p[604]
    beam200_clamped_free5_0_875_H_2_2 = p[605]
    beam200_clamped_free5_0_875_H_2_3 = p[606]
    beam200_clamped_free5_0_875_H_2_4 = p[607]
    beam200_clamped_free5_0_875_H_3_0 = p[608]
    beam200_clamped_free5_0_875_H_3_1 = p[609]
    beam200_clamped_free5_0_875_H_3_2 = p[610]
    beam200_clamped_free5_0_875_H_3_3 = p[611]
    beam200_clamped_free5_0_875_H_3_4 = p[612]
    beam200_clamped_free5_0_875_H_4_0 = p[613]
    beam200_clamped_free5_0_875_H_4_1 = p[614]
    beam200_clamped_free5_0_875_H_4_2 = p[615]
    beam200_clamped_free5_0_875_H_4_3 = p[616]
    beam200_clamped_free5_0_875_H_4_4 = p[617]
    beam200_clamped_free5_0_9375_at_0_0 = p[618]
    beam200_clamped_free5_0_9375_shape_1_0 = p[619]
    beam200_clamped_free5_0_9375_shape_1_1 = p[620]
    beam200_clamped_free5_0_9375_shape_1_2 = p[621]
    beam200_clamped_free5_0_9375_shape_1_3 = p[622]
    beam200_clamped_free5_0_9375_shape_1_4 = p[623]
    beam200_clamped_free5_0_9375_H_0_0 = p[629]
    beam200_clamped_free5_0_9375_H_0_1 = p[630]
    beam200_clamped_free5_0_9375_H_0_2 = p[631]
    beam200_clamped_free5_0_9375_H_0_3 = p[632]
    beam200_clamped_free5_0_9375_H_0_4 = p[633]
    beam200_clamped_free5_0_9375_H_1_0 = p[634]
    beam200_clamped_free5_0_9375_H_1_1 = p[635]
    beam200_clamped_free5_0_9375_H_1_2 = p[636]
    beam200_clamped_free5_0_9375_H_1_3 = p[637]
    beam200_clamped_free5_0_9375_H_1_4 = p[638]
    beam200_clamped_free5_0_9375_H_2_0 = p[639]
    beam200_clamped_free5_0_9375_H_2_1 = p[640]
    beam200_clamped_free5_0_9375_H_2_2 = p[641]
    beam200_clamped_free5_0_9375_H_2_3 = p[642]
    beam200_clamped_free5_0_9375_H_2_4 = p[643]
    beam200_clamped_free5_0_9375_H_3_0 = p[644]
    beam200_clamped_free5_0_9375_H_3_1 = p[645]
    beam200_clamped_free5_0_9375_H_3_2 = p[646]
    beam200_clamped_free5_0_9375_H_3_3 = p[647]
    beam200_clamped_free5_0_9375_H_3_4 = p[648]
    beam200_clamped_free5_0_9375_H_4_0 = p[649]
    beam200_clamped_free5_0_9375_H_4_1 = p[650]
    beam200_clamped_free5_0_9375_H_4_2 = p[651]
    beam200_clamped_free5_0_9375_H_4_3 = p[652]
    beam200_clamped_free5_0_9375_H_4_4 = p[653]
    w0 = beam_density * beam_area
    w1 = w0 * beam_length
    w2 = w1 * beam200_clamped_free5_mass_0_0
    w3 = w1 * beam200_clamped_free5_mass_1_1
    w4 = w1 * beam200_clamped_free5_mass_2_2
    w5 = w1 * beam200_clamped_free5_mass_3_3
    w6 = w1 * beam200_clamped_free5_mass_4_4
    w7 = w1 * beam200_clamped_free5_xH_0_0
    w8 = w1 * beam200_clamped_free5_xH_0_1
    w9 = w1 * beam200_clamped_free5_xH_0_2
    w10 = w1 * beam200_clamped_free5_xH_0_3
    w11 = w1 * beam200_clamped_free5_xH_0_4
    w12 = beam_length**2
    w13 = beam_youngs_modulus * beam_second_moment / (beam_length * w12)
    w14 = beam_length * w1
    w15 = (ramp / 6.283185307179586)**2
    w16 = 6.283185307179586 / ramp
    w17 = w1 * beam200_clamped_free5_xH_1_0
    w18 = w1 * beam200_clamped_free5_xH_1_1
    w19 = w1 * beam200_clamped_free5_xH_1_2
    w20 = w1 * beam200_clamped_free5_xH_1_3
    w21 = w1 * beam200_clamped_free5_xH_1_4
    w22 = w1 * beam200_clamped_free5_xH_2_0
    w23 = w1 * beam200_clamped_free5_xH_2_1
    w24 = w1 * beam200_clamped_free5_xH_2_2
    w25 = w1 * beam200_clamped_free5_xH_2_3
    w26 = w1 * beam200_clamped_free5_xH_2_4
    w27 = w1 * beam200_clamped_free5_xH_3_0
    w28 = w1 * beam200_clamped_free5_xH_3_1
    w29 = w1 * beam200_clamped_free5_xH_3_2
    w30 = w1 * beam200_clamped_free5_xH_3_3
    w31 = w1 * beam200_clamped_free5_xH_3_4
    w32 = w1 * beam200_clamped_free5_xH_4_0
    w33 = w1 * beam200_clamped_free5_xH_4_1
    w34 = w1 * beam200_clamped_free5_xH_4_2
    w35 = w1 * beam200_clamped_free5_xH_4_3
    w36 = w1 * beam200_clamped_free5_xH_4_4
    c = ca.vertcat(
        w2,
        w3,
        w4,
        w5,
        w6,
        w7,
        w8,
        w9,
        w10,
        w11,
        w13 * beam200_clamped_free5_kappa_lateral_0_0,
        ramp,
        w14 * beam200_clamped_free5_xi_phi_y_0_0,
        omega / ramp,
        w15 * w16**2,
        w17,
        w18,
        w19,
        w20,
        w21,
        w13 * beam200_clamped_free5_kappa_lateral_1_1,
        w14 * beam200_clamped_free5_xi_phi_y_1_0,
        w22,
        w23,
        w24,
        w25,
        w26,
        w13 * beam200_clamped_free5_kappa_lateral_2_2,
        w14 * beam200_clamped_free5_xi_phi_y_2_0,
        w27,
        w28,
        w29,
        w30,
        w31,
        w13 * beam200_clamped_free5_kappa_lateral_3_3,
        w14 * beam200_clamped_free5_xi_phi_y_3_0,
        w32,
        w33,
        w34,
        w35,
        w36,
        w13 * beam200_clamped_free5_kappa_lateral_4_4,
        w14 * beam200_clamped_free5_xi_phi_y_4_0,
        omega,
        w15,
        ramp / 2.0,
        w15 * w16,
        w1,
        w14 * beam200_clamped_free5_s1_0_0,
        w0 * beam200_clamped_free5_H_0_0,
        w0 * beam200_clamped_free5_H_0_1,
        w0 * beam200_clamped_free5_H_0_2,
        w0 * beam200_clamped_free5_H_0_3,
        w0 * beam200_clamped_free5_H_0_4,
        w0 * beam200_clamped_free5_H_1_0,
        w0 * beam200_clamped_free5_H_1_1,
        w0 * beam200_clamped_free5_H_1_2,
        w0 * beam200_clamped_free5_H_1_3,
        w0 * beam200_clamped_free5_H_1_4,
        w0 * beam200_clamped_free5_H_2_0,
        w0 * beam200_clamped_free5_H_2_1,
        w0 * beam200_clamped_free5_H_2_2,
        w0 * beam200_clamped_free5_H_2_3,
        w0 * beam200_clamped_free5_H_2_4,
        w0 * beam200_clamped_free5_H_3_0,
        w0 * beam200_clamped_free5_H_3_1,
        w0 * beam200_clamped_free5_H_3_2,
        w0 * beam200_clamped_free5_H_3_3,
        w0 * beam200_clamped_free5_H_3_4,
        w0 * beam200_clamped_free5_H_4_0,
        w0 * beam200_clamped_free5_H_4_1,
        w0 * beam200_clamped_free5_H_4_2,
        w0 * beam200_clamped_free5_H_4_3,
        w0 * beam200_clamped_free5_H_4_4,
        w1 * beam200_clamped_free5_phi_y_0_0,
        w1 * beam200_clamped_free5_phi_y_1_0,
        w1 * beam200_clamped_free5_phi_y_2_0,
        w1 * beam200_clamped_free5_phi_y_3_0,
        w1 * beam200_clamped_free5_phi_y_4_0,
        w1 * w12 * beam200_clamped_free5_i0_0_0,
        beam_length,
        beam200_clamped_free5_1_0_H_0_0 / beam_length,
        beam200_clamped_free5_1_0_H_0_1 / beam_length,
        beam200_clamped_free5_1_0_H_0_2 / beam_length,
        beam200_clamped_free5_1_0_H_0_3 / beam_length,
        beam200_clamped_free5_1_0_H_0_4 / beam_length,
        beam200_clamped_free5_1_0_H_1_0 / beam_length,
        beam200_clamped_free5_1_0_H_1_1 / beam_length,
        beam200_clamped_free5_1_0_H_1_2 / beam_length,
        beam200_clamped_free5_1_0_H_1_3 / beam_length,
        beam200_clamped_free5_1_0_H_1_4 / beam_length,
        beam200_clamped_free5_1_0_H_2_0 / beam_length,
        beam200_clamped_free5_1_0_H_2_1 / beam_length,
        beam200_clamped_free5_1_0_H_2_2 / beam_length,
        beam200_clamped_free5_1_0_H_2_3 / beam_length,
        beam200_clamped_free5_1_0_H_2_4 / beam_length,
        beam200_clamped_free5_1_0_H_3_0 / beam_length,
        beam200_clamped_free5_1_0_H_3_1 / beam_length,
        beam200_clamped_free5_1_0_H_3_2 / beam_length,
        beam200_clamped_free5_1_0_H_3_3 / beam_length,
        beam200_clamped_free5_1_0_H_3_4 / beam_length,
        beam200_clamped_free5_1_0_H_4_0 / beam_length,
        beam200_clamped_free5_1_0_H_4_1 / beam_length,
        beam200_clamped_free5_1_0_H_4_2 / beam_length,
        beam200_clamped_free5_1_0_H_4_3 / beam_length,
        beam200_clamped_free5_1_0_H_4_4 / beam_length,
        beam200_clamped_free5_1_0_shape_1_0,
        beam200_clamped_free5_1_0_shape_1_1,
        beam200_clamped_free5_1_0_shape_1_2,
        beam200_clamped_free5_1_0_shape_1_3,
        beam200_clamped_free5_1_0_shape_1_4,
        beam_length * beam200_clamped_free5_0_0625_at_0_0,
        beam200_clamped_free5_0_0625_H_0_0 / beam_length,
        beam200_clamped_free5_0_0625_H_0_1 / beam_length,
        beam200_clamped_free5_0_0625_H_0_2 / beam_length,
        beam200_clamped_free5_0_0625_H_0_3 / beam_length,
        beam200_clamped_free5_0_0625_H_0_4 / beam_length,
        beam200_clamped_free5_0_0625_H_1_0 / beam_length,
        beam200_clamped_free5_0_0625_H_1_1 / beam_length,
        beam200_clamped_free5_0_0625_H_1_2 / beam_length,
        beam200_clamped_free5_0_0625_H_1_3 / beam_length,
        beam200_clamped_free5_0_0625_H_1_4 / beam_length,
        beam200_clamped_free5_0_0625_H_2_0 / beam_length,
        beam200_clamped_free5_0_0625_H_2_1 / beam_length,
        beam200_clamped_free5_0_0625_H_2_2 / beam_length,
        beam200_clamped_free5_0_0625_H_2_3 / beam_length,
        beam200_clamped_free5_0_0625_H_2_4 / beam_length,
        beam200_clamped_free5_0_0625_H_3_0 / beam_length,
        beam200_clamped_free5_0_0625_H_3_1 / beam_length,
        beam200_clamped_free5_0_0625_H_3_2 / beam_length,
        beam200_clamped_free5_0_0625_H_3_3 / beam_length,
        beam200_clamped_free5_0_0625_H_3_4 / beam_length,
        beam200_clamped_free5_0_0625_H_4_0 / beam_length,
        beam200_clamped_free5_0_0625_H_4_1 / beam_length,
        beam200_clamped_free5_0_0625_H_4_2 / beam_length,
        beam200_clamped_free5_0_0625_H_4_3 / beam_length,
        beam200_clamped_free5_0_0625_H_4_4 / beam_length,
        beam200_clamped_free5_0_0625_shape_1_0,
        beam200_clamped_free5_0_0625_shape_1_1,
        beam200_clamped_free5_0_0625_shape_1_2,
        beam200_clamped_free5_0_0625_shape_1_3,
        beam200_clamped_free5_0_0625_shape_1_4,
        beam_length * beam200_clamped_free5_0_125_at_0_0,
        beam200_clamped_free5_0_125_H_0_0 / beam_length,
        beam200_clamped_free5_0_125_H_0_1 / beam_length,
        beam200_clamped_free5_0_125_H_0_2 / beam_length,
        beam200_clamped_free5_0_125_H_0_3 / beam_length,
        beam200_clamped_free5_0_125_H_0_4 / beam_length,
        beam200_clamped_free5_0_125_H_1_0 / beam_length,
        beam200_clamped_free5_0_125_H_1_1 / beam_length,
        beam200_clamped_free5_0_125_H_1_2 / beam_length,
        beam200_clamped_free5_0_125_H_1_3 / beam_length,
        beam200_clamped_free5_0_125_H_1_4 / beam_length,
        beam200_clamped_free5_0_125_H_2_0 / beam_length,
        beam200_clamped_free5_0_125_H_2_1 / beam_length,
        beam200_clamped_free5_0_125_H_2_2 / beam_length,
        beam200_clamped_free5_0_125_H_2_3 / beam_length,
        beam200_clamped_free5_0_125_H_2_4 / beam_length,
        beam200_clamped_free5_0_125_H_3_0 / beam_length,
        beam200_clamped_free5_0_125_H_3_1 / beam_length,
        beam200_clamped_free5_0_125_H_3_2 / beam_length,
        beam200_clamped_free5_0_125_H_3_3 / beam_length,
        beam200_clamped_free5_0_125_H_3_4 / beam_length,
        beam200_clamped_free5_0_125_H_4_0 / beam_length,
        beam200_clamped_free5_0_125_H_4_1 / beam_length,
        beam200_clamped_free5_0_125_H_4_2 / beam_length,
        beam200_clamped_free5_0_125_H_4_3 / beam_length,
        beam200_clamped_free5_0_125_H_4_4 / beam_length,
        beam200_clamped_free5_0_125_shape_1_0,
        beam200_clamped_free5_0_125_shape_1_1,
        beam200_clamped_free5_0_125_shape_1_2,
        beam200_clamped_free5_0_125_shape_1_3,
        beam200_clamped_free5_0_125_shape_1_4,
        beam_length * beam200_clamped_free5_0_1875_at_0_0,
        beam200_clamped_free5_0_1875_H_0_0 / beam_length,
        beam200_clamped_free5_0_1875_H_0_1 / beam_length,
        beam200_clamped_free5_0_1875_H_0_2 / beam_length,
        beam200_clamped_free5_0_1875_H_0_3 / beam_length,
        beam200_clamped_free5_0_1875_H_0_4 / beam_length,
        beam200_clamped_free5_0_1875_H_1_0 / beam_length,
        beam200_clamped_free5_0_1875_H_1_1 / beam_length,
        beam200_clamped_free5_0_1875_H_1_2 / beam_length,
        beam200_clamped_free5_0_1875_H_1_3 / beam_length,
        beam200_clamped_free5_0_1875_H_1_4 / beam_length,
        beam200_clamped_free5_0_1875_H_2_0 / beam_length,
        beam200_clamped_free5_0_1875_H_2_1 / beam_length,
        beam200_clamped_free5_0_1875_H_2_2 / beam_length,
        beam200_clamped_free5_0_1875_H_2_3 / beam_length,
        beam200_clamped_free5_0_1875_H_2_4 / beam_length,
        beam200_clamped_free5_0_1875_H_3_0 / beam_length,
        beam200_clamped_free5_0_1875_H_3_1 / beam_length,
        beam200_clamped_free5_0_1875_H_3_2 / beam_length,
        beam200_clamped_free5_0_1875_H_3_3 / beam_length,
        beam200_clamped_free5_0_1875_H_3_4 / beam_length,
        beam200_clamped_free5_0_1875_H_4_0 / beam_length,
        beam200_clamped_free5_0_1875_H_4_1 / beam_length,
        beam200_clamped_free5_0_1875_H_4_2 / beam_length,
        beam200_clamped_free5_0_1875_H_4_3 / beam_length,
        beam200_clamped_free5_0_1875_H_4_4 / beam_length,
        beam200_clamped_free5_0_1875_shape_1_0,
        beam200_clamped_free5_0_1875_shape_1_1,
        beam200_clamped_free5_0_1875_shape_1_2,
        beam200_clamped_free5_0_1875_shape_1_3,
        beam200_clamped_free5_0_1875_shape_1_4,
        beam_length * beam200_clamped_free5_0_25_at_0_0,
        beam200_clamped_free5_0_25_H_0_0 / beam_length,
        beam200_clamped_free5_0_25_H_0_1 / beam_length,
        beam200_clamped_free5_0_25_H_0_2 / beam_length,
        beam200_clamped_free5_0_25_H_0_3 / beam_length,
        beam200_clamped_free5_0_25_H_0_4 / beam_length,
        beam200_clamped_free5_0_25_H_1_0 / beam_length,
        beam200_clamped_free5_0_25_H_1_1 / beam_length,
        beam200_clamped_free5_0_25_H_1_2 / beam_length,
        beam200_clamped_free5_0_25_H_1_3 / beam_length,
        beam200_clamped_free5_0_25_H_1_4 / beam_length,
        beam200_clamped_free5_0_25_H_2_0 / beam_length,
        beam200_clamped_free5_0_25_H_2_1 / beam_length,
        beam200_clamped_free5_0_25_H_2_2 / beam_length,
        beam200_clamped_free5_0_25_H_2_3 / beam_length,
        beam200_clamped_free5_0_25_H_2_4 / beam_length,
        beam200_clamped_free5_0_25_H_3_0 / beam_length,
        beam200_clamped_free5_0_25_H_3_1 / beam_length,
        beam200_clamped_free5_0_25_H_3_2 / beam_length,
        beam200_clamped_free5_0_25_H_3_3 / beam_length,
        beam200_clamped_free5_0_25_H_3_4 / beam_length,
        beam200_clamped_free5_0_25_H_4_0 / beam_length,
        beam200_clamped_free5_0_25_H_4_1 / beam_length,
        beam200_clamped_free5_0_25_H_4_2 / beam_length,
        beam200_clamped_free5_0_25_H_4_3 / beam_length,
        beam200_clamped_free5_0_25_H_4_4 / beam_length,
        beam200_clamped_free5_0_25_shape_1_0,
        beam200_clamped_free5_0_25_shape_1_1,
        beam200_clamped_free5_0_25_shape_1_2,
        beam200_clamped_free5_0_25_shape_1_3,
        beam200_clamped_free5_0_25_shape_1_4,
        beam_length * beam200_clamped_free5_0_3125_at_0_0,
        beam200_clamped_free5_0_3125_H_0_0 / beam_length,
        beam200_clamped_free5_0_3125_H_0_1 / beam_length,
        beam200_clamped_free5_0_3125_H_0_2 / beam_length,
        beam200_clamped_free5_0_3125_H_0_3 / beam_length,
        beam200_clamped_free5_0_3125_H_0_4 / beam_length,
        beam200_clamped_free5_0_3125_H_1_0 / beam_length,
        beam200_clamped_free5_0_3125_H_1_1 / beam_length,
        beam200_clamped_free5_0_3125_H_1_2 / beam_length,
        beam200_clamped_free5_0_3125_H_1_3 / beam_length,
        beam200_clamped_free5_0_3125_H_1_4 / beam_length,
        beam200_clamped_free5_0_3125_H_2_0 / beam_length,
        beam200_clamped_free5_0_3125_H_2_1 / beam_length,
        beam200_clamped_free5_0_3125_H_2_2 / beam_length,
        beam200_clamped_free5_0_3125_H_2_3 / beam_length,
        beam200_clamped_free5_0_3125_H_2_4 / beam_length,
        beam200_clamped_free5_0_3125_H_3_0 / beam_length,
        beam200_clamped_free5_0_3125_H_3_1 / beam_length,
        beam200_clamped_free5_0_3125_H_3_2 / beam_length,
        beam200_clamped_free5_0_3125_H_3_3 / beam_length,
        beam200_clamped_free5_0_3125_H_3_4 / beam_length,
        beam200_clamped_free5_0_3125_H_4_0 / beam_length,
        beam200_clamped_free5_0_3125_H_4_1 / beam_length,
        beam200_clamped_free5_0_3125_H_4_2 / beam_length,
        beam200_clamped_free5_0_3125_H_4_3 / beam_length,
        beam200_clamped_free5_0_3125_H_4_4 / beam_length,
        beam200_clamped_free5_0_3125_shape_1_0,
        beam200_clamped_free5_0_3125_shape_1_1,
        beam200_clamped_free5_0_3125_shape_1_2,
        beam200_clamped_free5_0_3125_shape_1_3,
        beam200_clamped_free5_0_3125_shape_1_4,
        beam_length * beam200_clamped_free5_0_375_at_0_0,
        beam200_clamped_free5_0_375_H_0_0 / beam_length,
        beam200_clamped_free5_0_375_H_0_1 / beam_length,
        beam200_clamped_free5_0_375_H_0_2 / beam_length,
        beam200_clamped_free5_0_375_H_0_3 / beam_length,
        beam200_clamped_free5_0_375_H_0_4 / beam_length,
        beam200_clamped_free5_0_375_H_1_0 / beam_length,
        beam200_clamped_free5_0_375_H_1_1 / beam_length,
        beam200_clamped_free5_0_375_H_1_2 / beam_length,
        beam200_clamped_free5_0_375_H_1_3 / beam_length,
        beam200_clamped_free5_0_375_H_1_4 / beam_length,
        beam200_clamped_free5_0_375_H_2_0 / beam_length,
        beam200_clamped_free5_0_375_H_2_1 / beam_length,
        beam200_clamped_free5_0_375_H_2_2 / beam_length,
        beam200_clamped_free5_0_375_H_2_3 / beam_length,
        beam200_clamped_free5_0_375_H_2_4 / beam_length,
        beam200_clamped_free5_0_375_H_3_0 / beam_length,
        beam200_clamped_free5_0_375_H_3_1 / beam_length,
        beam200_clamped_free5_0_375_H_3_2 / beam_length,
        beam200_clamped_free5_0_375_H_3_3 / beam_length,
        beam200_clamped_free5_0_375_H_3_4 / beam_length,
        beam200_clamped_free5_0_375_H_4_0 / beam_length,
        beam200_clamped_free5_0_375_H_4_1 / beam_length,
        beam200_clamped_free5_0_375_H_4_2 / beam_length,
        beam200_clamped_free5_0_375_H_4_3 / beam_length,
        beam200_clamped_free5_0_375_H_4_4 / beam_length,
        beam200_clamped_free5_0_375_shape_1_0,
        beam200_clamped_free5_0_375_shape_1_1,
        beam200_clamped_free5_0_375_shape_1_2,
        beam200_clamped_free5_0_375_shape_1_3,
        beam200_clamped_free5_0_375_shape_1_4,
        beam_length * beam200_clamped_free5_0_4375_at_0_0,
        beam200_clamped_free5_0_4375_H_0_0 / beam_length,
        beam200_clamped_free5_0_4375_H_0_1 / beam_length,
        beam200_clamped_free5_0_4375_H_0_2 / beam_length,
        beam200_clamped_free5_0_4375_H_0_3 / beam_length,
        beam200_clamped_free5_0_4375_H_0_4 / beam_length,
        beam200_clamped_free5_0_4375_H_1_0 / beam_length,
        beam200_clamped_free5_0_4375_H_1_1 / beam_length,
        beam200_clamped_free5_0_4375_H_1_2 / beam_length,
        beam200_clamped_free5_0_4375_H_1_3 / beam_length,
        beam200_clamped_free5_0_4375_H_1_4 / beam_length,
        beam200_clamped_free5_0_4375_H_2_0 / beam_length,
        beam200_clamped_free5_0_4375_H_2_1 / beam_length,
        beam200_clamped_free5_0_4375_H_2_2 / beam_length,
        beam200_clamped_free5_0_4375_H_2_3 / beam_length,
        beam200_clamped_free5_0_4375_H_2_4 / beam_length,
        beam200_clamped_free5_0_4375_H_3_0 / beam_length,
        beam200_clamped_free5_0_4375_H_3_1 / beam_length,
        beam200_clamped_free5_0_4375_H_3_2 / beam_length,
        beam200_clamped_free5_0_4375_H_3_3 / beam_length,
        beam200_clamped_free5_0_4375_H_3_4 / beam_length,
        beam200_clamped_free5_0_4375_H_4_0 / beam_length,
        beam200_clamped_free5_0_4375_H_4_1 / beam_length,
        beam200_clamped_free5_0_4375_H_4_2 / beam_length,
        beam200_clamped_free5_0_4375_H_4_3 / beam_length,
        beam200_clamped_free5_0_4375_H_4_4 / beam_length,
        beam200_clamped_free5_0_4375_shape_1_0,
        beam200_clamped_free5_0_4375_shape_1_1,
        beam200_clamped_free5_0_4375_shape_1_2,
        beam200_clamped_free5_0_4375_shape_1_3,
        beam200_clamped_free5_0_4375_shape_1_4,
        beam_length * beam200_clamped_free5_0_5_at_0_0,
        beam200_clamped_free5_0_5_H_0_0 / beam_length,
        beam200_clamped_free5_0_5_H_0_1 / beam_length,
        beam200_clamped_free5_0_5_H_0_2 / beam_length,
        beam200_clamped_free5_0_5_H_0_3 / beam_length,
        beam200_clamped_free5_0_5_H_0_4 / beam_length,
        beam200_clamped_free5_0_5_H_1_0 / beam_length,
        beam200_clamped_free5_0_5_H_1_1 / beam_length,
        beam200_clamped_free5_0_5_H_1_2 / beam_length,
        beam200_clamped_free5_0_5_H_1_3 / beam_length,
        beam200_clamped_free5_0_5_H_1_4 / beam_length,
        beam200_clamped_free5_0_5_H_2_0 / beam_length,
        beam200_clamped_free5_0_5_H_2_1 / beam_length,
        beam200_clamped_free5_0_5_H_2_2 / beam_length,
        beam200_clamped_free5_0_5_H_2_3 / beam_length,
        beam200_clamped_free5_0_5_H_2_4 / beam_length,
        beam200_clamped_free5_0_5_H_3_0 / beam_length,
        beam200_clamped_free5_0_5_H_3_1 / beam_length,
        beam200_clamped_free5_0_5_H_3_2 / beam_length,
        beam200_clamped_free5_0_5_H_3_3 / beam_length,
        beam200_clamped_free5_0_5_H_3_4 / beam_length,
        beam200_clamped_free5_0_5_H_4_0 / beam_length,
        beam200_clamped_free5_0_5_H_4_1 / beam_length,
        beam200_clamped_free5_0_5_H_4_2 / beam_length,
        beam200_clamped_free5_0_5_H_4_3 / beam_length,
        beam200_clamped_free5_0_5_H_4_4 / beam_length,
        beam200_clamped_free5_0_5_shape_1_0,
        beam200_clamped_free5_0_5_shape_1_1,
        beam200_clamped_free5_0_5_shape_1_2,
        beam200_clamped_free5_0_5_shape_1_3,
        beam200_clamped_free5_0_5_shape_1_4,
        beam_length * beam200_clamped_free5_0_5625_at_0_0,
        beam200_clamped_free5_0_5625_H_0_0 / beam_length,
        beam200_clamped_free5_0_5625_H_0_1 / beam_length,
        beam200_clamped_free5_0_5625_H_0_2 / beam_length,
        beam200_clamped_free5_0_5625_H_0_3 / beam_length,
        beam200_clamped_free5_0_5625_H_0_4 / beam_length,
        beam200_clamped_free5_0_5625_H_1_0 / beam_length,
        beam200_clamped_free5_0_5625_H_1_1 / beam_length,
        beam200_clamped_free5_0_5625_H_1_2 / beam_length,
        beam200_clamped_free5_0_5625_H_1_3 / beam_length,
        beam200_clamped_free5_0_5625_H_1_4 / beam_length,
        beam200_clamped_free5_0_5625_H_2_0 / beam_length,
        beam200_clamped_free5_0_5625_H_2_1 / beam_length,
        beam200_clamped_free5_0_5625_H_2_2 / beam_length,
        beam200_clamped_free5_0_5625_H_2_3 / beam_length,
        beam200_clamped_free5_0_5625_H_2_4 / beam_length,
        beam200_clamped_free5_0_5625_H_3_0 / beam_length,
        beam200_clamped_free5_0_5625_H_3_1 / beam_length,
        beam200_clamped_free5_0_5625_H_3_2 / beam_length,
        beam200_clamped_free5_0_5625_H_3_3 / beam_length,
        beam200_clamped_free5_0_5625_H_3_4 / beam_length,
        beam200_clamped_free5_0_5625_H_4_0 / beam_length,
        beam200_clamped_free5_0_5625_H_4_1 / beam_length,
        beam200_clamped_free5_0_5625_H_4_2 / beam_length,
        beam200_clamped_free5_0_5625_H_4_3 / beam_length,
        beam200_clamped_free5_0_5625_H_4_4 / beam_length,
        beam200_clamped_free5_0_5625_shape_1_0,
        beam200_clamped_free5_0_5625_shape_1_1,
        beam200_clamped_free5_0_5625_shape_1_2,
        beam200_clamped_free5_0_5625_shape_1_3,
        beam200_clamped_free5_0_5625_shape_1_4,
        beam_length * beam200_clamped_free5_0_625_at_0_0,
        beam200_clamped_free5_0_625_H_0_0 / beam_length,
        beam200_clamped_free5_0_625_H_0_1 / beam_length,
        beam200_clamped_free5_0_625_H_0_2 / beam_length,
        beam200_clamped_free5_0_625_H_0_3 / beam_length,
        beam200_clamped_free5_0_625_H_0_4 / beam_length,
        beam200_clamped_free5_0_625_H_1_0 / beam_length,
        beam200_clamped_free5_0_625_H_1_1 / beam_length,
        beam200_clamped_free5_0_625_H_1_2 / beam_length,
        beam200_clamped_free5_0_625_H_1_3 / beam_length,
        beam200_clamped_free5_0_625_H_1_4 / beam_length,
        beam200_clamped_free5_0_625_H_2_0 / beam_length,
        beam200_clamped_free5_0_625_H_2_1 / beam_length,
        beam200_clamped_free5_0_625_H_2_2 / beam_length,
        beam200_clamped_free5_0_625_H_2_3 / beam_length,
        beam200_clamped_free5_0_625_H_2_4 / beam_length,
        beam200_clamped_free5_0_625_H_3_0 / beam_length,
        beam200_clamped_free5_0_625_H_3_1 / beam_length,
        beam200_clamped_free5_0_625_H_3_2 / beam_length,
        beam200_clamped_free5_0_625_H_3_3 / beam_length,
        beam200_clamped_free5_0_625_H_3_4 / beam_length,
        beam200_clamped_free5_0_625_H_4_0 / beam_length,
        beam200_clamped_free5_0_625_H_4_1 / beam_length,
        beam200_clamped_free5_0_625_H_4_2 / beam_length,
        beam200_clamped_free5_0_625_H_4_3 / beam_length,
        beam200_clamped_free5_0_625_H_4_4 / beam_length,
        beam200_clamped_free5_0_625_shape_1_0,
        beam200_clamped_free5_0_625_shape_1_1,
        beam200_clamped_free5_0_625_shape_1_2,
        beam200_clamped_free5_0_625_shape_1_3,
        beam200_clamped_free5_0_625_shape_1_4,
        beam_length * beam200_clamped_free5_0_6875_at_0_0,
        beam200_clamped_free5_0_6875_H_0_0 / beam_length,
        beam200_clamped_free5_0_6875_H_0_1 / beam_length,
        beam200_clamped_free5_0_6875_H_0_2 / beam_length,
        beam200_clamped_free5_0_6875_H_0_3 / beam_length,
        beam200_clamped_free5_0_6875_H_0_4 / beam_length,
        beam200_clamped_free5_0_6875_H_1_0 / beam_length,
        beam200_clamped_free5_0_6875_H_1_1 / beam_length,
        beam200_clamped_free5_0_6875_H_1_2 / beam_length,
        beam200_clamped_free5_0_6875_H_1_3 / beam_length,
        beam200_clamped_free5_0_6875_H_1_4 / beam_length,
        beam200_clamped_free5_0_6875_H_2_0 / beam_length,
        beam200_clamped_free5_0_6875_H_2_1 / beam_length,
        beam200_clamped_free5_0_6875_H_2_2 / beam_length,
        beam200_clamped_free5_0_6875_H_2_3 / beam_length,
        beam200_clamped_free5_0_6875_H_2_4 / beam_length,
        beam200_clamped_free5_0_6875_H_3_0 / beam_length,
        beam200_clamped_free5_0_6875_H_3_1 / beam_length,
        beam200_clamped_free5_0_6875_H_3_2 / beam_length,
        beam200_clamped_free5_0_6875_H_3_3 / beam_length,
        beam200_clamped_free5_0_6875_H_3_4 / beam_length,
        beam200_clamped_free5_0_6875_H_4_0 / beam_length,
        beam200_clamped_free5_0_6875_H_4_1 / beam_length,
        beam200_clamped_free5_0_6875_H_4_2 / beam_length,
        beam200_clamped_free5_0_6875_H_4_3 / beam_length,
        beam200_clamped_free5_0_6875_H_4_4 / beam_length,
        beam200_clamped_free5_0_6875_shape_1_0,
        beam200_clamped_free5_0_6875_shape_1_1,
        beam200_clamped_free5_0_6875_shape_1_2,
        beam200_clamped_free5_0_6875_shape_1_3,
        beam200_clamped_free5_0_6875_shape_1_4,
        beam_length * beam200_clamped_free5_0_75_at_0_0,
        beam200_clamped_free5_0_75_H_0_0 / beam_length,
        beam200_clamped_free5_0_75_H_0_1 / beam_length,
        beam200_clamped_free5_0_75_H_0_2 / beam_length,
        beam200_clamped_free5_0_75_H_0_3 / beam_length,
        beam200_clamped_free5_0_75_H_0_4 / beam_length,
        beam200_clamped_free5_0_75_H_1_0 / beam_length,
        beam200_clamped_free5_0_75_H_1_1 / beam_length,
        beam200_clamped_free5_0_75_H_1_2 / beam_length,
        beam200_clamped_free5_0_75_H_1_3 / beam_length,
        beam200_clamped_free5_0_75_H_1_4 / beam_length,
        beam200_clamped_free5_0_75_H_2_0 / beam_length,
        beam200_clamped_free5_0_75_H_2_1 / beam_length,
        beam200_clamped_free5_0_75_H_2_2 / beam_length,
        beam200_clamped_free5_0_75_H_2_3 / beam_length,
        beam200_clamped_free5_0_75_H_2_4 / beam_length,
        beam200_clamped_free5_0_75_H_3_0 / beam_length,
        beam200_clamped_free5_0_75_H_3_1 / beam_length,
        beam200_clamped_free5_0_75_H_3_2 / beam_length,
        beam200_clamped_free5_0_75_H_3_3 / beam_length,
        beam200_clamped_free5_0_75_H_3_4 / beam_length,
        beam200_clamped_free5_0_75_H_4_0 / beam_length,
        beam200_clamped_free5_0_75_H_4_1 / beam_length,
        beam200_clamped_free5_0_75_H_4_2 / beam_length,
        beam200_clamped_free5_0_75_H_4_3 / beam_length,
        beam200_clamped_free5_0_75_H_4_4 / beam_length,
        beam200_clamped_free5_0_75_shape_1_0,
        beam200_clamped_free5_0_75_shape_1_1,
        beam200_clamped_free5_0_75_shape_1_2,
        beam200_clamped_free5_0_75_shape_1_3,
        beam200_clamped_free5_0_75_shape_1_4,
        beam_length * beam200_clamped_free5_0_8125_at_0_0,
        beam200_clamped_free5_0_8125_H_0_0 / beam_length,
        beam200_clamped_free5_0_8125_H_0_1 / beam_length,
        beam200_clamped_free5_0_8125_H_0_2 / beam_length,
        beam200_clamped_free5_0_8125_H_0_3 / beam_length,
        beam200_clamped_free5_0_8125_H_0_4 / beam_length,
        beam200_clamped_free5_0_8125_H_1_0 / beam_length,
        beam200_clamped_free5_0_8125_H_1_1 / beam_length,
        beam200_clamped_free5_0_8125_H_1_2 / beam_length,
        beam200_clamped_free5_0_8125_H_1_3 / beam_length,
        beam200_clamped_free5_0_8125_H_1_4 / beam_length,
        beam200_clamped_free5_0_8125_H_2_0 / beam_length,
        beam200_clamped_free5_0_8125_H_2_1 / beam_length,
        beam200_clamped_free5_0_8125_H_2_2 / beam_length,
        beam200_clamped_free5_0_8125_H_2_3 / beam_length,
        beam200_clamped_free5_0_8125_H_2_4 / beam_length,
        beam200_clamped_free5_0_8125_H_3_0 / beam_length,
        beam200_clamped_free5_0_8125_H_3_1 / beam_length,
        beam200_clamped_free5_0_8125_H_3_2 / beam_length,
        beam200_clamped_free5_0_8125_H_3_3 / beam_length,
        beam200_clamped_free5_0_8125_H_3_4 / beam_length,
        beam200_clamped_free5_0_8125_H_4_0 / beam_length,
        beam200_clamped_free5_0_8125_H_4_1 / beam_length,
        beam200_clamped_free5_0_8125_H_4_2 / beam_length,
        beam200_clamped_free5_0_8125_H_4_3 / beam_length,
        beam200_clamped_free5_0_8125_H_4_4 / beam_length,
        beam200_clamped_free5_0_8125_shape_1_0,
        beam200_clamped_free5_0_8125_shape_1_1,
        beam200_clamped_free5_0_8125_shape_1_2,
        beam200_clamped_free5_0_8125_shape_1_3,
        beam200_clamped_free5_0_8125_shape_1_4,
        beam_length * beam200_clamped_free5_0_875_at_0_0,
        beam200_clamped_free5_0_875_H_0_0 / beam_length,
        beam200_clamped_free5_0_875_H_0_1 / beam_length,
        beam200_clamped_free5_0_875_H_0_2 / beam_length,
        beam200_clamped_free5_0_875_H_0_3 / beam_length,
        beam200_clamped_free5_0_875_H_0_4 / beam_length,
        beam200_clamped_free5_0_875_H_1_0 / beam_length,
        beam200_clamped_free5_0_875_H_1_1 / beam_length,
        beam200_clamped_free5_0_875_H_1_2 / beam_length,
        beam200_clamped_free5_0_875_H_1_3 / beam_length,
        beam200_clamped_free5_0_875_H_1_4 / beam_length,
        beam200_clamped_free5_0_875_H_2_0 / beam_length,
        beam200_clamped_free5_0_875_H_2_1 / beam_length,
        beam200_clamped_free5_0_875_H_2_2 / beam_length,
        beam200_clamped_free5_0_875_H_2_3 / beam_length,
        beam200_clamped_free5_0_875_H_2_4 / beam_length,
        beam200_clamped_free5_0_875_H_3_0 / beam_length,
        beam200_clamped_free5_0_875_H_3_1 / beam_length,
        beam200_clamped_free5_0_875_H_3_2 / beam_length,
        beam200_clamped_free5_0_875_H_3_3 / beam_length,
        beam200_clamped_free5_0_875_H_3_4 / beam_length,
        beam200_clamped_free5_0_875_H_4_0 / beam_length,
        beam200_clamped_free5_0_875_H_4_1 / beam_length,
        beam200_clamped_free5_0_875_H_4_2 / beam_length,
        beam200_clamped_free5_0_875_H_4_3 / beam_length,
        beam200_clamped_free5_0_875_H_4_4 / beam_length,
        beam200_clamped_free5_0_875_shape_1_0,
        beam200_clamped_free5_0_875_shape_1_1,
        beam200_clamped_free5_0_875_shape_1_2,
        beam200_clamped_free5_0_875_shape_1_3,
        beam200_clamped_free5_0_875_shape_1_4,
        beam_length * beam200_clamped_free5_0_9375_at_0_0,
        beam200_clamped_free5_0_9375_H_0_0 / beam_length,
        beam200_clamped_free5_0_9375_H_0_1 / beam_length,
        beam200_clamped_free5_0_9375_H_0_2 / beam_length,
        beam200_clamped_free5_0_9375_H_0_3 / beam_length,
        beam200_clamped_free5_0_9375_H_0_4 / beam_length,
        beam200_clamped_free5_0_9375_H_1_0 / beam_length,
        beam200_clamped_free5_0_9375_H_1_1 / beam_length,
        beam200_clamped_free5_0_9375_H_1_2 / beam_length,
        beam200_clamped_free5_0_9375_H_1_3 / beam_length,
        beam200_clamped_free5_0_9375_H_1_4 / beam_length,
        beam200_clamped_free5_0_9375_H_2_0 / beam_length,
        beam200_clamped_free5_0_9375_H_2_1 / beam_length,
        beam200_clamped_free5_0_9375_H_2_2 / beam_length,
        beam200_clamped_free5_0_9375_H_2_3 / beam_length,
        beam200_clamped_free5_0_9375_H_2_4 / beam_length,
        beam200_clamped_free5_0_9375_H_3_0 / beam_length,
        beam200_clamped_free5_0_9375_H_3_1 / beam_length,
        beam200_clamped_free5_0_9375_H_3_2 / beam_length,
        beam200_clamped_free5_0_9375_H_3_3 / beam_length,
        beam200_clamped_free5_0_9375_H_3_4 / beam_length,
        beam200_clamped_free5_0_9375_H_4_0 / beam_length,
        beam200_clamped_free5_0_9375_H_4_1 / beam_length,
        beam200_clamped_free5_0_9375_H_4_2 / beam_length,
        beam200_clamped_free5_0_9375_H_4_3 / beam_length,
        beam200_clamped_free5_0_9375_H_4_4 / beam_length,
        beam200_clamped_free5_0_9375_shape_1_0,
        beam200_clamped_free5_0_9375_shape_1_1,
        beam200_clamped_free5_0_9375_shape_1_2,
        beam200_clamped_free5_0_9375_shape_1_3,
        beam200_clamped_free5_0_9375_shape_1_4,
        w2 - w7,
        -w17,
        -w22,
        -w27,
        -w32,
        -w8,
        w3 - w18,
        -w23,
        -w28,
        -w33,
        -w9,
        -w19,
        w4 - w24,
        -w29,
        -w34,
        -w10,
        -w20,
        -w25,
        w5 - w30,
        -w35,
        -w11,
        -w21,
        -w26,
        -w31,
        w6 - w36,
    )
    c = ca.densify(c)
    inputs, outputs = [p], [c]
    return ca.Function("constants", inputs, outputs, ["p"], ["c"])


def condensed() -> ca.Function:
    """M_hat and Q_hat (Eq. 38). 176 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 3)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 601)
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
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    w0 = beam_theta_dot**2
    w1 = w0 * (beam_q1 * c0 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7 + beam_q4 * c8 + beam_q5 * c9)) - beam_q1 * c10
    w2 = t < c11
    w3 = (1.0 - ca.cos(t * 6.283185307179586 / c11) * c14) * c13
    w4 = w0 * (beam_q2 * c1 - (beam_q1 * c15 + beam_q2 * c16 + beam_q3 * c17 + beam_q4 * c18 + beam_q5 * c19))
    w5 = w0 * (beam_q3 * c2 - (beam_q1 * c22 + beam_q2 * c23 + beam_q3 * c24 + beam_q4 * c25 + beam_q5 * c26))
    w6 = w0 * (beam_q4 * c3 - (beam_q1 * c29 + beam_q2 * c30 + beam_q3 * c31 + beam_q4 * c32 + beam_q5 * c33))
    w7 = w0 * (beam_q5 * c4 - (beam_q1 * c36 + beam_q2 * c37 + beam_q3 * c38 + beam_q4 * c39 + beam_q5 * c40))
    M_hat = ca.vertcat(
        c0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c1,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c2,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c3,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c4,
    )
    M_hat = ca.reshape(M_hat, 5, 5)
    M_hat = ca.densify(M_hat)
    Q_hat = ca.vertcat(
        w1 - ca.if_else(w2, w3 * c12, 0),
        w4 - beam_q2 * c20 - ca.if_else(w2, w3 * c21, 0),
        w5 - beam_q3 * c27 - ca.if_else(w2, w3 * c28, 0),
        w6 - beam_q4 * c34 - ca.if_else(w2, w3 * c35, 0),
        w7 - beam_q5 * c41 - ca.if_else(w2, w3 * c42, 0),
    )
    Q_hat = ca.densify(Q_hat)
    inputs, outputs = [q_i, q_d_dot, t, c], [M_hat, Q_hat]
    return ca.Function("condensed", inputs, outputs, ["q_i", "q_d_dot", "t", "c"], ["M_hat", "Q_hat"])


def closure() -> ca.Function:
    """One Newton step on the loop unknowns, then q_d (Eq. 31); C_loop before it, det_loop of its blocks. 29 operations."""
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 601)
    c11 = c[11]
    c13 = c[13]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    w0 = t < c11
    w1 = ca.if_else(w0, (t**2 / 2.0 + (ca.cos(t * 6.283185307179586 / c11) - 1.0) * c44) * c13, 0) + ca.if_else(ca.logic_not(w0), (t - c45) * c43, 0)
    q_d_next = ca.vertcat(
        0.0,
        0.0,
        w1,
    )
    q_d_next = ca.densify(q_d_next)
    inputs, outputs = [t, c], [q_d_next]
    return ca.Function("closure", inputs, outputs, ["t", "c"], ["q_d_next"])


def velocities() -> ca.Function:
    """q_d_dot (Eq. 36). 21 operations."""
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 601)
    c11 = c[11]
    c13 = c[13]
    c43 = c[43]
    c46 = c[46]
    w0 = t < c11
    w1 = ca.if_else(w0, (t - ca.sin(t * 6.283185307179586 / c11) * c46) * c13, 0) + ca.if_else(ca.logic_not(w0), c43, 0)
    q_d_dot = ca.vertcat(
        0.0,
        0.0,
        w1,
    )
    q_d_dot = ca.densify(q_d_dot)
    inputs, outputs = [t, c], [q_d_dot]
    return ca.Function("velocities", inputs, outputs, ["t", "c"], ["q_d_dot"])


def accelerations() -> ca.Function:
    """q_d_ddot (Eq. 35). 18 operations."""
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 601)
    c11 = c[11]
    c13 = c[13]
    c14 = c[14]
    q_d_ddot = ca.vertcat(
        0.0,
        0.0,
        ca.if_else(t < c11, (1.0 - ca.cos(t * 6.283185307179586 / c11) * c14) * c13, 0),
    )
    q_d_ddot = ca.densify(q_d_ddot)
    inputs, outputs = [t, c], [q_d_ddot]
    return ca.Function("accelerations", inputs, outputs, ["t", "c"], ["q_d_ddot"])


def constraints() -> ca.Function:
    """C, C_q, C_t, nu and gamma in all coordinates (Eqs. 21-27). 80 operations."""
    q = ca.SX.sym("q", 8)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 601)
    beam_x = q[0]
    beam_y = q[1]
    beam_theta = q[2]
    c11 = c[11]
    c13 = c[13]
    c14 = c[14]
    c43 = c[43]
    c44 = c[44]
    c45 = c[45]
    c46 = c[46]
    w0 = t < c11
    w1 = t * 6.283185307179586 / c11
    w2 = ca.cos(w1)
    w3 = ca.logic_not(w0)
    w4 = beam_theta - (ca.if_else(w0, (t**2 / 2.0 + (w2 - 1.0) * c44) * c13, 0) + ca.if_else(w3, (t - c45) * c43, 0))
    w5 = ca.if_else(w0, (t - ca.sin(w1) * c46) * c13, 0) + ca.if_else(w3, c43, 0)
    C = ca.vertcat(
        beam_x,
        beam_y,
        w4,
    )
    C = ca.densify(C)
    C_q = ca.vertcat(
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
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
    C_q = ca.reshape(C_q, 3, 8)
    C_q = ca.densify(C_q)
    C_t = ca.vertcat(
        0.0,
        0.0,
        -w5,
    )
    C_t = ca.densify(C_t)
    nu = ca.vertcat(
        0.0,
        0.0,
        w5,
    )
    nu = ca.densify(nu)
    gamma = ca.vertcat(
        0.0,
        0.0,
        ca.if_else(w0, (1.0 - w2 * c14) * c13, 0),
    )
    gamma = ca.densify(gamma)
    inputs, outputs = [q, t, c], [C, C_q, C_t, nu, gamma]
    return ca.Function("constraints", inputs, outputs, ["q", "t", "c"], ["C", "C_q", "C_t", "nu", "gamma"])


def augmented() -> ca.Function:
    """M, K, Q_v, Q_F, Q* = Q_F + Q_v - K q, C_q and gamma (with Baumgarte terms) of Eq. (28). 571 operations."""
    q = ca.SX.sym("q", 8)
    q_dot = ca.SX.sym("q_dot", 8)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 601)
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
    w11 = -(w1 * w7 + w0 * c74)
    w12 = -(w2 * w7 + w0 * c75)
    w13 = -(w3 * w7 + w0 * c76)
    w14 = -(w4 * w7 + w0 * c77)
    w15 = -(w5 * w7 + w0 * c78)
    w16 = w6 * w7 - w0 * w8
    w17 = w7 * c74 - w0 * w1
    w18 = w7 * c75 - w0 * w2
    w19 = w7 * c76 - w0 * w3
    w20 = w7 * c77 - w0 * w4
    w21 = w7 * c78 - w0 * w5
    w22 = beam_q1 * c0 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7 + beam_q4 * c8 + beam_q5 * c9)
    w23 = beam_q2 * c1 - (beam_q1 * c15 + beam_q2 * c16 + beam_q3 * c17 + beam_q4 * c18 + beam_q5 * c19)
    w24 = beam_q3 * c2 - (beam_q1 * c22 + beam_q2 * c23 + beam_q3 * c24 + beam_q4 * c25 + beam_q5 * c26)
    w25 = beam_q4 * c3 - (beam_q1 * c29 + beam_q2 * c30 + beam_q3 * c31 + beam_q4 * c32 + beam_q5 * c33)
    w26 = beam_q5 * c4 - (beam_q1 * c36 + beam_q2 * c37 + beam_q3 * c38 + beam_q4 * c39 + beam_q5 * c40)
    w27 = beam_theta_dot**2
    w28 = 2 * beam_theta_dot
    w29 = beam_q1_dot * c74 + beam_q2_dot * c75 + beam_q3_dot * c76 + beam_q4_dot * c77 + beam_q5_dot * c78
    w30 = w1 * beam_q1_dot + w2 * beam_q2_dot + w3 * beam_q3_dot + w4 * beam_q4_dot + w5 * beam_q5_dot
    w31 = beam_q1_dot * c49 + beam_q2_dot * c50 + beam_q3_dot * c51 + beam_q4_dot * c52 + beam_q5_dot * c53
    w32 = beam_q1_dot * c54 + beam_q2_dot * c55 + beam_q3_dot * c56 + beam_q4_dot * c57 + beam_q5_dot * c58
    w33 = beam_q1_dot * c59 + beam_q2_dot * c60 + beam_q3_dot * c61 + beam_q4_dot * c62 + beam_q5_dot * c63
    w34 = beam_q1_dot * c64 + beam_q2_dot * c65 + beam_q3_dot * c66 + beam_q4_dot * c67 + beam_q5_dot * c68
    w35 = beam_q1_dot * c69 + beam_q2_dot * c70 + beam_q3_dot * c71 + beam_q4_dot * c72 + beam_q5_dot * c73
    w36 = beam_q1_dot * w31 + beam_q2_dot * w32 + beam_q3_dot * w33 + beam_q4_dot * w34 + beam_q5_dot * w35
    w37 = w16 * w27 + w28 * (w7 * w29 - w0 * w30) + w7 * w36
    w38 = w9 * w27 + w0 * w36 + w28 * (w7 * w30 + w0 * w29)
    w39 = w22 * beam_q1_dot + w23 * beam_q2_dot + w24 * beam_q3_dot + w25 * beam_q4_dot + w26 * beam_q5_dot
    w40 = beam_theta_dot * -2.0 * w39
    w41 = w22 * w27
    w42 = w23 * w27
    w43 = w24 * w27
    w44 = w25 * w27
    w45 = w26 * w27
    M = ca.vertcat(
        c47,
        0.0,
        w10,
        w11,
        w12,
        w13,
        w14,
        w15,
        0.0,
        c47,
        w16,
        w17,
        w18,
        w19,
        w20,
        w21,
        w10,
        w16,
        c79 + (beam_q1 * w22 + beam_q2 * w23 + beam_q3 * w24 + beam_q4 * w25 + beam_q5 * w26),
        c12,
        c21,
        c28,
        c35,
        c42,
        w11,
        w17,
        c12,
        c0,
        0.0,
        0.0,
        0.0,
        0.0,
        w12,
        w18,
        c21,
        0.0,
        c1,
        0.0,
        0.0,
        0.0,
        w13,
        w19,
        c28,
        0.0,
        0.0,
        c2,
        0.0,
        0.0,
        w14,
        w20,
        c35,
        0.0,
        0.0,
        0.0,
        c3,
        0.0,
        w15,
        w21,
        c42,
        0.0,
        0.0,
        0.0,
        0.0,
        c4,
    )
    M = ca.reshape(M, 8, 8)
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
        c10,
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
        c27,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c34,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c41,
    )
    K = ca.reshape(K, 8, 8)
    K = ca.densify(K)
    Q_v = ca.vertcat(
        w37,
        w38,
        w40,
        w41,
        w42,
        w43,
        w44,
        w45,
    )
    Q_v = ca.densify(Q_v)
    Q_F = ca.vertcat(
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
    )
    Q_F = ca.densify(Q_F)
    Q_star = ca.vertcat(
        w37,
        w38,
        w40,
        w41 - beam_q1 * c10,
        w42 - beam_q2 * c20,
        w43 - beam_q3 * c27,
        w44 - beam_q4 * c34,
        w45 - beam_q5 * c41,
    )
    Q_star = ca.densify(Q_star)
    C_q = ca.vertcat(
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
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
    C_q = ca.reshape(C_q, 3, 8)
    C_q = ca.densify(C_q)
    gamma_b = ca.vertcat(
        0.0,
        0.0,
        ca.if_else(t < c11, (1.0 - ca.cos(t * 6.283185307179586 / c11) * c14) * c13, 0),
    )
    gamma_b = ca.densify(gamma_b)
    inputs, outputs = [q, q_dot, t, c], [M, K, Q_v, Q_F, Q_star, C_q, gamma_b]
    return ca.Function("augmented", inputs, outputs, ["q", "q_dot", "t", "c"], ["M", "K", "Q_v", "Q_F", "Q_star", "C_q", "gamma_b"])


def reactions() -> ca.Function:
    """Multipliers lam (Eq. 37); world force and moment of each joint on its body b, at marker b. 416 operations."""
    q = ca.SX.sym("q", 8)
    q_dot = ca.SX.sym("q_dot", 8)
    q_ddot = ca.SX.sym("q_ddot", 8)
    c = ca.SX.sym("c", 601)
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
    lam = ca.vertcat(
        w23,
        w26,
        w35,
    )
    lam = ca.densify(lam)
    joint_forces = ca.vertcat(
        -w23,
        -w26,
        0.0,
        0.0,
        0.0,
        -w35,
    )
    joint_forces = ca.reshape(joint_forces, 3, 2)
    joint_forces = ca.densify(joint_forces)
    inputs, outputs = [q, q_dot, q_ddot, c], [lam, joint_forces]
    return ca.Function("reactions", inputs, outputs, ["q", "q_dot", "q_ddot", "c"], ["lam", "joint_forces"])


def energy() -> ca.Function:
    """Energies in J and powers in W. 370 operations."""
    q = ca.SX.sym("q", 8)
    q_dot = ca.SX.sym("q_dot", 8)
    c = ca.SX.sym("c", 601)
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
    kinetic = ca.vertcat(
        w35 / 2.0,
    )
    kinetic = ca.densify(kinetic)
    elastic = ca.vertcat(
        (w36 + beam_q5 * (beam_q5 * c41)) / 2.0,
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
        0.0,
    )
    power_applied = ca.densify(power_applied)
    inputs, outputs = [q, q_dot, c], [kinetic, elastic, potential, power_dissipated, power_applied]
    return ca.Function("energy", inputs, outputs, ["q", "q_dot", "c"], ["kinetic", "elastic", "potential", "power_dissipated", "power_applied"])


def measures() -> ca.Function:
    """The scene's measures and their rates. 219 operations."""
    q = ca.SX.sym("q", 8)
    q_dot = ca.SX.sym("q_dot", 8)
    c = ca.SX.sym("c", 601)
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
    w0 = ca.cos(beam_theta)
    w1 = beam_q1 * c81 + beam_q2 * c82 + beam_q3 * c83 + beam_q4 * c84 + beam_q5 * c85
    w2 = beam_q1 * c86 + beam_q2 * c87 + beam_q3 * c88 + beam_q4 * c89 + beam_q5 * c90
    w3 = beam_q1 * c91 + beam_q2 * c92 + beam_q3 * c93 + beam_q4 * c94 + beam_q5 * c95
    w4 = beam_q1 * c96 + beam_q2 * c97 + beam_q3 * c98 + beam_q4 * c99 + beam_q5 * c100
    w5 = beam_q1 * c101 + beam_q2 * c102 + beam_q3 * c103 + beam_q4 * c104 + beam_q5 * c105
    w6 = c80 - (beam_q1 * w1 + beam_q2 * w2 + beam_q3 * w3 + beam_q4 * w4 + beam_q5 * w5) * 0.5
    w7 = ca.sin(beam_theta)
    w8 = beam_q1 * c106 + beam_q2 * c107 + beam_q3 * c108 + beam_q4 * c109 + beam_q5 * c110
    w9 = w7 * beam_theta_dot
    w10 = beam_q1_dot * c81 + beam_q2_dot * c82 + beam_q3_dot * c83 + beam_q4_dot * c84 + beam_q5_dot * c85
    w11 = beam_q1_dot * c86 + beam_q2_dot * c87 + beam_q3_dot * c88 + beam_q4_dot * c89 + beam_q5_dot * c90
    w12 = beam_q1_dot * c91 + beam_q2_dot * c92 + beam_q3_dot * c93 + beam_q4_dot * c94 + beam_q5_dot * c95
    w13 = w1 * beam_q1_dot + beam_q1 * w10 + (w2 * beam_q2_dot + beam_q2 * w11) + (w3 * beam_q3_dot + beam_q3 * w12)
    w14 = beam_q1_dot * c96 + beam_q2_dot * c97 + beam_q3_dot * c98 + beam_q4_dot * c99 + beam_q5_dot * c100
    w15 = beam_q1_dot * c101 + beam_q2_dot * c102 + beam_q3_dot * c103 + beam_q4_dot * c104 + beam_q5_dot * c105
    w16 = (w13 + (w4 * beam_q4_dot + beam_q4 * w14) + (w5 * beam_q5_dot + beam_q5 * w15)) * 0.5
    w17 = w0 * beam_theta_dot
    w18 = beam_q1_dot * c106 + beam_q2_dot * c107 + beam_q3_dot * c108 + beam_q4_dot * c109 + beam_q5_dot * c110
    measures = ca.vertcat(
        beam_x + (w0 * w6 - w7 * w8),
        beam_x_dot - (w6 * w9 + w0 * w16 + (w8 * w17 + w7 * w18)),
        beam_y + (w6 * w7 + w0 * w8),
        beam_y_dot + (w6 * w17 - w7 * w16 + (w0 * w18 - w8 * w9)),
    )
    measures = ca.densify(measures)
    inputs, outputs = [q, q_dot, c], [measures]
    return ca.Function("measures", inputs, outputs, ["q", "q_dot", "c"], ["measures"])


def drawing() -> ca.Function:
    """World points of the polylines that show the bodies. 1715 operations."""
    q = ca.SX.sym("q", 8)
    exaggeration = ca.SX.sym("exaggeration", 1)
    c = ca.SX.sym("c", 601)
    beam_x = q[0]
    beam_y = q[1]
    beam_theta = q[2]
    beam_q1 = q[3]
    beam_q2 = q[4]
    beam_q3 = q[5]
    beam_q4 = q[6]
    beam_q5 = q[7]
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
    c245 = c[245]
    c246 = c[246]
    c247 = c[247]
    c248 = c[248]
    c249 = c[249]
    c250 = c[250]
    c251 = c[251]
    c252 = c[252]
    c253 = c[253]
    c254 = c[254]
    c255 = c[255]
    c256 = c[256]
    c257 = c[257]
    c258 = c[258]
    c259 = c[259]
    c260 = c[260]
    c261 = c[261]
    c262 = c[262]
    c263 = c[263]
    c264 = c[264]
    c265 = c[265]
    c266 = c[266]
    c267 = c[267]
    c268 = c[268]
    c269 = c[269]
    c270 = c[270]
    c271 = c[271]
    c272 = c[272]
    c273 = c[273]
    c274 = c[274]
    c275 = c[275]
    c276 = c[276]
    c277 = c[277]
    c278 = c[278]
    c279 = c[279]
    c280 = c[280]
    c281 = c[281]
    c282 = c[282]
    c283 = c[283]
    c284 = c[284]
    c285 = c[285]
    c286 = c[286]
    c287 = c[287]
    c288 = c[288]
    c289 = c[289]
    c290 = c[290]
    c291 = c[291]
    c292 = c[292]
    c293 = c[293]
    c294 = c[294]
    c295 = c[295]
    c296 = c[296]
    c297 = c[297]
    c298 = c[298]
    c299 = c[299]
    c300 = c[300]
    c301 = c[301]
    c302 = c[302]
    c303 = c[303]
    c304 = c[304]
    c305 = c[305]
    c306 = c[306]
    c307 = c[307]
    c308 = c[308]
    c309 = c[309]
    c310 = c[310]
    c311 = c[311]
    c312 = c[312]
    c313 = c[313]
    c314 = c[314]
    c315 = c[315]
    c316 = c[316]
    c317 = c[317]
    c318 = c[318]
    c319 = c[319]
    c320 = c[320]
    c321 = c[321]
    c322 = c[322]
    c323 = c[323]
    c324 = c[324]
    c325 = c[325]
    c326 = c[326]
    c327 = c[327]
    c328 = c[328]
    c329 = c[329]
    c330 = c[330]
    c331 = c[331]
    c332 = c[332]
    c333 = c[333]
    c334 = c[334]
    c335 = c[335]
    c336 = c[336]
    c337 = c[337]
    c338 = c[338]
    c339 = c[339]
    c340 = c[340]
    c341 = c[341]
    c342 = c[342]
    c343 = c[343]
    c344 = c[344]
    c345 = c[345]
    c346 = c[346]
    c347 = c[347]
    c348 = c[348]
    c349 = c[349]
    c350 = c[350]
    c351 = c[351]
    c352 = c[352]
    c353 = c[353]
    c354 = c[354]
    c355 = c[355]
    c356 = c[356]
    c357 = c[357]
    c358 = c[358]
    c359 = c[359]
    c360 = c[360]
    c361 = c[361]
    c362 = c[362]
    c363 = c[363]
    c364 = c[364]
    c365 = c[365]
    c366 = c[366]
    c367 = c[367]
    c368 = c[368]
    c369 = c[369]
    c370 = c[370]
    c371 = c[371]
    c372 = c[372]
    c373 = c[373]
    c374 = c[374]
    c375 = c[375]
    c376 = c[376]
    c377 = c[377]
    c378 = c[378]
    c379 = c[379]
    c380 = c[380]
    c381 = c[381]
    c382 = c[382]
    c383 = c[383]
    c384 = c[384]
    c385 = c[385]
    c386 = c[386]
    c387 = c[387]
    c388 = c[388]
    c389 = c[389]
    c390 = c[390]
    c391 = c[391]
    c392 = c[392]
    c393 = c[393]
    c394 = c[394]
    c395 = c[395]
    c396 = c[396]
    c397 = c[397]
    c398 = c[398]
    c399 = c[399]
    c400 = c[400]
    c401 = c[401]
    c402 = c[402]
    c403 = c[403]
    c404 = c[404]
    c405 = c[405]
    c406 = c[406]
    c407 = c[407]
    c408 = c[408]
    c409 = c[409]
    c410 = c[410]
    c411 = c[411]
    c412 = c[412]
    c413 = c[413]
    c414 = c[414]
    c415 = c[415]
    c416 = c[416]
    c417 = c[417]
    c418 = c[418]
    c419 = c[419]
    c420 = c[420]
    c421 = c[421]
    c422 = c[422]
    c423 = c[423]
    c424 = c[424]
    c425 = c[425]
    c426 = c[426]
    c427 = c[427]
    c428 = c[428]
    c429 = c[429]
    c430 = c[430]
    c431 = c[431]
    c432 = c[432]
    c433 = c[433]
    c434 = c[434]
    c435 = c[435]
    c436 = c[436]
    c437 = c[437]
    c438 = c[438]
    c439 = c[439]
    c440 = c[440]
    c441 = c[441]
    c442 = c[442]
    c443 = c[443]
    c444 = c[444]
    c445 = c[445]
    c446 = c[446]
    c447 = c[447]
    c448 = c[448]
    c449 = c[449]
    c450 = c[450]
    c451 = c[451]
    c452 = c[452]
    c453 = c[453]
    c454 = c[454]
    c455 = c[455]
    c456 = c[456]
    c457 = c[457]
    c458 = c[458]
    c459 = c[459]
    c460 = c[460]
    c461 = c[461]
    c462 = c[462]
    c463 = c[463]
    c464 = c[464]
    c465 = c[465]
    c466 = c[466]
    c467 = c[467]
    c468 = c[468]
    c469 = c[469]
    c470 = c[470]
    c471 = c[471]
    c472 = c[472]
    c473 = c[473]
    c474 = c[474]
    c475 = c[475]
    c476 = c[476]
    c477 = c[477]
    c478 = c[478]
    c479 = c[479]
    c480 = c[480]
    c481 = c[481]
    c482 = c[482]
    c483 = c[483]
    c484 = c[484]
    c485 = c[485]
    c486 = c[486]
    c487 = c[487]
    c488 = c[488]
    c489 = c[489]
    c490 = c[490]
    c491 = c[491]
    c492 = c[492]
    c493 = c[493]
    c494 = c[494]
    c495 = c[495]
    c496 = c[496]
    c497 = c[497]
    c498 = c[498]
    c499 = c[499]
    c500 = c[500]
    c501 = c[501]
    c502 = c[502]
    c503 = c[503]
    c504 = c[504]
    c505 = c[505]
    c506 = c[506]
    c507 = c[507]
    c508 = c[508]
    c509 = c[509]
    c510 = c[510]
    c511 = c[511]
    c512 = c[512]
    c513 = c[513]
    c514 = c[514]
    c515 = c[515]
    c516 = c[516]
    c517 = c[517]
    c518 = c[518]
    c519 = c[519]
    c520 = c[520]
    c521 = c[521]
    c522 = c[522]
    c523 = c[523]
    c524 = c[524]
    c525 = c[525]
    c526 = c[526]
    c527 = c[527]
    c528 = c[528]
    c529 = c[529]
    c530 = c[530]
    c531 = c[531]
    c532 = c[532]
    c533 = c[533]
    c534 = c[534]
    c535 = c[535]
    c536 = c[536]
    c537 = c[537]
    c538 = c[538]
    c539 = c[539]
    c540 = c[540]
    c541 = c[541]
    c542 = c[542]
    c543 = c[543]
    c544 = c[544]
    c545 = c[545]
    c546 = c[546]
    c547 = c[547]
    c548 = c[548]
    c549 = c[549]
    c550 = c[550]
    c551 = c[551]
    c552 = c[552]
    c553 = c[553]
    c554 = c[554]
    c555 = c[555]
    c556 = c[556]
    c557 = c[557]
    c558 = c[558]
    c559 = c[559]
    c560 = c[560]
    c561 = c[561]
    c562 = c[562]
    c563 = c[563]
    c564 = c[564]
    c565 = c[565]
    c566 = c[566]
    c567 = c[567]
    c568 = c[568]
    c569 = c[569]
    c570 = c[570]
    c571 = c[571]
    c572 = c[572]
    c573 = c[573]
    c574 = c[574]
    c575 = c[575]
    w0 = ca.cos(beam_theta)
    w1 = beam_q1 * exaggeration
    w2 = exaggeration * beam_q2
    w3 = exaggeration * beam_q3
    w4 = exaggeration * beam_q4
    w5 = exaggeration * beam_q5
    w6 = w1 * (w1 * c112 + w2 * c113 + w3 * c114 + w4 * c115 + w5 * c116) + w2 * (w1 * c117 + w2 * c118 + w3 * c119 + w4 * c120 + w5 * c121)
    w7 = w6 + w3 * (w1 * c122 + w2 * c123 + w3 * c124 + w4 * c125 + w5 * c126) + w4 * (w1 * c127 + w2 * c128 + w3 * c129 + w4 * c130 + w5 * c131)
    w8 = c111 - (w7 + w5 * (w1 * c132 + w2 * c133 + w3 * c134 + w4 * c135 + w5 * c136)) * 0.5
    w9 = ca.sin(beam_theta)
    w10 = w1 * c137 + w2 * c138 + w3 * c139 + w4 * c140 + w5 * c141
    w11 = w1 * (w1 * c143 + w2 * c144 + w3 * c145 + w4 * c146 + w5 * c147) + w2 * (w1 * c148 + w2 * c149 + w3 * c150 + w4 * c151 + w5 * c152)
    w12 = w11 + w3 * (w1 * c153 + w2 * c154 + w3 * c155 + w4 * c156 + w5 * c157) + w4 * (w1 * c158 + w2 * c159 + w3 * c160 + w4 * c161 + w5 * c162)
    w13 = c142 - (w12 + w5 * (w1 * c163 + w2 * c164 + w3 * c165 + w4 * c166 + w5 * c167)) * 0.5
    w14 = w1 * c168 + w2 * c169 + w3 * c170 + w4 * c171 + w5 * c172
    w15 = w1 * (w1 * c174 + w2 * c175 + w3 * c176 + w4 * c177 + w5 * c178) + w2 * (w1 * c179 + w2 * c180 + w3 * c181 + w4 * c182 + w5 * c183)
    w16 = w15 + w3 * (w1 * c184 + w2 * c185 + w3 * c186 + w4 * c187 + w5 * c188) + w4 * (w1 * c189 + w2 * c190 + w3 * c191 + w4 * c192 + w5 * c193)
    w17 = c173 - (w16 + w5 * (w1 * c194 + w2 * c195 + w3 * c196 + w4 * c197 + w5 * c198)) * 0.5
    w18 = w1 * c199 + w2 * c200 + w3 * c201 + w4 * c202 + w5 * c203
    w19 = w1 * (w1 * c205 + w2 * c206 + w3 * c207 + w4 * c208 + w5 * c209) + w2 * (w1 * c210 + w2 * c211 + w3 * c212 + w4 * c213 + w5 * c214)
    w20 = w19 + w3 * (w1 * c215 + w2 * c216 + w3 * c217 + w4 * c218 + w5 * c219) + w4 * (w1 * c220 + w2 * c221 + w3 * c222 + w4 * c223 + w5 * c224)
    w21 = c204 - (w20 + w5 * (w1 * c225 + w2 * c226 + w3 * c227 + w4 * c228 + w5 * c229)) * 0.5
    w22 = w1 * c230 + w2 * c231 + w3 * c232 + w4 * c233 + w5 * c234
    w23 = w1 * (w1 * c236 + w2 * c237 + w3 * c238 + w4 * c239 + w5 * c240) + w2 * (w1 * c241 + w2 * c242 + w3 * c243 + w4 * c244 + w5 * c245)
    w24 = w23 + w3 * (w1 * c246 + w2 * c247 + w3 * c248 + w4 * c249 + w5 * c250) + w4 * (w1 * c251 + w2 * c252 + w3 * c253 + w4 * c254 + w5 * c255)
    w25 = c235 - (w24 + w5 * (w1 * c256 + w2 * c257 + w3 * c258 + w4 * c259 + w5 * c260)) * 0.5
    w26 = w1 * c261 + w2 * c262 + w3 * c263 + w4 * c264 + w5 * c265
    w27 = w1 * (w1 * c267 + w2 * c268 + w3 * c269 + w4 * c270 + w5 * c271) + w2 * (w1 * c272 + w2 * c273 + w3 * c274 + w4 * c275 + w5 * c276)
    w28 = w27 + w3 * (w1 * c277 + w2 * c278 + w3 * c279 + w4 * c280 + w5 * c281) + w4 * (w1 * c282 + w2 * c283 + w3 * c284 + w4 * c285 + w5 * c286)
    w29 = c266 - (w28 + w5 * (w1 * c287 + w2 * c288 + w3 * c289 + w4 * c290 + w5 * c291)) * 0.5
    w30 = w1 * c292 + w2 * c293 + w3 * c294 + w4 * c295 + w5 * c296
    w31 = w1 * (w1 * c298 + w2 * c299 + w3 * c300 + w4 * c301 + w5 * c302) + w2 * (w1 * c303 + w2 * c304 + w3 * c305 + w4 * c306 + w5 * c307)
    w32 = w31 + w3 * (w1 * c308 + w2 * c309 + w3 * c310 + w4 * c311 + w5 * c312) + w4 * (w1 * c313 + w2 * c314 + w3 * c315 + w4 * c316 + w5 * c317)
    w33 = c297 - (w32 + w5 * (w1 * c318 + w2 * c319 + w3 * c320 + w4 * c321 + w5 * c322)) * 0.5
    w34 = w1 * c323 + w2 * c324 + w3 * c325 + w4 * c326 + w5 * c327
    w35 = w1 * (w1 * c329 + w2 * c330 + w3 * c331 + w4 * c332 + w5 * c333) + w2 * (w1 * c334 + w2 * c335 + w3 * c336 + w4 * c337 + w5 * c338)
    w36 = w35 + w3 * (w1 * c339 + w2 * c340 + w3 * c341 + w4 * c342 + w5 * c343) + w4 * (w1 * c344 + w2 * c345 + w3 * c346 + w4 * c347 + w5 * c348)
    w37 = c328 - (w36 + w5 * (w1 * c349 + w2 * c350 + w3 * c351 + w4 * c352 + w5 * c353)) * 0.5
    w38 = w1 * c354 + w2 * c355 + w3 * c356 + w4 * c357 + w5 * c358
    w39 = w1 * (w1 * c360 + w2 * c361 + w3 * c362 + w4 * c363 + w5 * c364) + w2 * (w1 * c365 + w2 * c366 + w3 * c367 + w4 * c368 + w5 * c369)
    w40 = w39 + w3 * (w1 * c370 + w2 * c371 + w3 * c372 + w4 * c373 + w5 * c374) + w4 * (w1 * c375 + w2 * c376 + w3 * c377 + w4 * c378 + w5 * c379)
    w41 = c359 - (w40 + w5 * (w1 * c380 + w2 * c381 + w3 * c382 + w4 * c383 + w5 * c384)) * 0.5
    w42 = w1 * c385 + w2 * c386 + w3 * c387 + w4 * c388 + w5 * c389
    w43 = w1 * (w1 * c391 + w2 * c392 + w3 * c393 + w4 * c394 + w5 * c395) + w2 * (w1 * c396 + w2 * c397 + w3 * c398 + w4 * c399 + w5 * c400)
    w44 = w43 + w3 * (w1 * c401 + w2 * c402 + w3 * c403 + w4 * c404 + w5 * c405) + w4 * (w1 * c406 + w2 * c407 + w3 * c408 + w4 * c409 + w5 * c410)
    w45 = c390 - (w44 + w5 * (w1 * c411 + w2 * c412 + w3 * c413 + w4 * c414 + w5 * c415)) * 0.5
    w46 = w1 * c416 + w2 * c417 + w3 * c418 + w4 * c419 + w5 * c420
    w47 = w1 * (w1 * c422 + w2 * c423 + w3 * c424 + w4 * c425 + w5 * c426) + w2 * (w1 * c427 + w2 * c428 + w3 * c429 + w4 * c430 + w5 * c431)
    w48 = w47 + w3 * (w1 * c432 + w2 * c433 + w3 * c434 + w4 * c435 + w5 * c436) + w4 * (w1 * c437 + w2 * c438 + w3 * c439 + w4 * c440 + w5 * c441)
    w49 = c421 - (w48 + w5 * (w1 * c442 + w2 * c443 + w3 * c444 + w4 * c445 + w5 * c446)) * 0.5
    w50 = w1 * c447 + w2 * c448 + w3 * c449 + w4 * c450 + w5 * c451
    w51 = w1 * (w1 * c453 + w2 * c454 + w3 * c455 + w4 * c456 + w5 * c457) + w2 * (w1 * c458 + w2 * c459 + w3 * c460 + w4 * c461 + w5 * c462)
    w52 = w51 + w3 * (w1 * c463 + w2 * c464 + w3 * c465 + w4 * c466 + w5 * c467) + w4 * (w1 * c468 + w2 * c469 + w3 * c470 + w4 * c471 + w5 * c472)
    w53 = c452 - (w52 + w5 * (w1 * c473 + w2 * c474 + w3 * c475 + w4 * c476 + w5 * c477)) * 0.5
    w54 = w1 * c478 + w2 * c479 + w3 * c480 + w4 * c481 + w5 * c482
    w55 = w1 * (w1 * c484 + w2 * c485 + w3 * c486 + w4 * c487 + w5 * c488) + w2 * (w1 * c489 + w2 * c490 + w3 * c491 + w4 * c492 + w5 * c493)
    w56 = w55 + w3 * (w1 * c494 + w2 * c495 + w3 * c496 + w4 * c497 + w5 * c498) + w4 * (w1 * c499 + w2 * c500 + w3 * c501 + w4 * c502 + w5 * c503)
    w57 = c483 - (w56 + w5 * (w1 * c504 + w2 * c505 + w3 * c506 + w4 * c507 + w5 * c508)) * 0.5
    w58 = w1 * c509 + w2 * c510 + w3 * c511 + w4 * c512 + w5 * c513
    w59 = w1 * (w1 * c515 + w2 * c516 + w3 * c517 + w4 * c518 + w5 * c519) + w2 * (w1 * c520 + w2 * c521 + w3 * c522 + w4 * c523 + w5 * c524)
    w60 = w59 + w3 * (w1 * c525 + w2 * c526 + w3 * c527 + w4 * c528 + w5 * c529) + w4 * (w1 * c530 + w2 * c531 + w3 * c532 + w4 * c533 + w5 * c534)
    w61 = c514 - (w60 + w5 * (w1 * c535 + w2 * c536 + w3 * c537 + w4 * c538 + w5 * c539)) * 0.5
    w62 = w1 * c540 + w2 * c541 + w3 * c542 + w4 * c543 + w5 * c544
    w63 = w1 * (w1 * c546 + w2 * c547 + w3 * c548 + w4 * c549 + w5 * c550) + w2 * (w1 * c551 + w2 * c552 + w3 * c553 + w4 * c554 + w5 * c555)
    w64 = w63 + w3 * (w1 * c556 + w2 * c557 + w3 * c558 + w4 * c559 + w5 * c560) + w4 * (w1 * c561 + w2 * c562 + w3 * c563 + w4 * c564 + w5 * c565)
    w65 = c545 - (w64 + w5 * (w1 * c566 + w2 * c567 + w3 * c568 + w4 * c569 + w5 * c570)) * 0.5
    w66 = w1 * c571 + w2 * c572 + w3 * c573 + w4 * c574 + w5 * c575
    w67 = w1 * (w1 * c81 + w2 * c82 + w3 * c83 + w4 * c84 + w5 * c85) + w2 * (w1 * c86 + w2 * c87 + w3 * c88 + w4 * c89 + w5 * c90)
    w68 = w67 + w3 * (w1 * c91 + w2 * c92 + w3 * c93 + w4 * c94 + w5 * c95) + w4 * (w1 * c96 + w2 * c97 + w3 * c98 + w4 * c99 + w5 * c100)
    w69 = c80 - (w68 + w5 * (w1 * c101 + w2 * c102 + w3 * c103 + w4 * c104 + w5 * c105)) * 0.5
    w70 = w1 * c106 + w2 * c107 + w3 * c108 + w4 * c109 + w5 * c110
    xy = ca.vertcat(
        beam_x,
        beam_y,
        beam_x + (w0 * w8 - w9 * w10),
        beam_y + (w8 * w9 + w0 * w10),
        beam_x + (w0 * w13 - w9 * w14),
        beam_y + (w9 * w13 + w0 * w14),
        beam_x + (w0 * w17 - w9 * w18),
        beam_y + (w9 * w17 + w0 * w18),
        beam_x + (w0 * w21 - w9 * w22),
        beam_y + (w9 * w21 + w0 * w22),
        beam_x + (w0 * w25 - w9 * w26),
        beam_y + (w9 * w25 + w0 * w26),
        beam_x + (w0 * w29 - w9 * w30),
        beam_y + (w9 * w29 + w0 * w30),
        beam_x + (w0 * w33 - w9 * w34),
        beam_y + (w9 * w33 + w0 * w34),
        beam_x + (w0 * w37 - w9 * w38),
        beam_y + (w9 * w37 + w0 * w38),
        beam_x + (w0 * w41 - w9 * w42),
        beam_y + (w9 * w41 + w0 * w42),
        beam_x + (w0 * w45 - w9 * w46),
        beam_y + (w9 * w45 + w0 * w46),
        beam_x + (w0 * w49 - w9 * w50),
        beam_y + (w9 * w49 + w0 * w50),
        beam_x + (w0 * w53 - w9 * w54),
        beam_y + (w9 * w53 + w0 * w54),
        beam_x + (w0 * w57 - w9 * w58),
        beam_y + (w9 * w57 + w0 * w58),
        beam_x + (w0 * w61 - w9 * w62),
        beam_y + (w9 * w61 + w0 * w62),
        beam_x + (w0 * w65 - w9 * w66),
        beam_y + (w9 * w65 + w0 * w66),
        beam_x + (w0 * w69 - w9 * w70),
        beam_y + (w9 * w69 + w0 * w70),
    )
    xy = ca.reshape(xy, 2, 17)
    xy = ca.densify(xy)
    inputs, outputs = [q, exaggeration, c], [xy]
    return ca.Function("drawing", inputs, outputs, ["q", "exaggeration", "c"], ["xy"])


def dQ_hat_dq_i() -> ca.Function:
    """Total derivative of Q_hat by q_i, through q_d = f(q_i, t). 87 operations."""
    q_d_dot = ca.SX.sym("q_d_dot", 3)
    c = ca.SX.sym("c", 601)
    beam_theta_dot = q_d_dot[2]
    c10 = c[10]
    c20 = c[20]
    c27 = c[27]
    c34 = c[34]
    c41 = c[41]
    c576 = c[576]
    c577 = c[577]
    c578 = c[578]
    c579 = c[579]
    c580 = c[580]
    c581 = c[581]
    c582 = c[582]
    c583 = c[583]
    c584 = c[584]
    c585 = c[585]
    c586 = c[586]
    c587 = c[587]
    c588 = c[588]
    c589 = c[589]
    c590 = c[590]
    c591 = c[591]
    c592 = c[592]
    c593 = c[593]
    c594 = c[594]
    c595 = c[595]
    c596 = c[596]
    c597 = c[597]
    c598 = c[598]
    c599 = c[599]
    c600 = c[600]
    w0 = beam_theta_dot**2
    dQ_hat_dq_i = ca.vertcat(
        w0 * c576 - c10,
        w0 * c577,
        w0 * c578,
        w0 * c579,
        w0 * c580,
        w0 * c581,
        w0 * c582 - c20,
        w0 * c583,
        w0 * c584,
        w0 * c585,
        w0 * c586,
        w0 * c587,
        w0 * c588 - c27,
        w0 * c589,
        w0 * c590,
        w0 * c591,
        w0 * c592,
        w0 * c593,
        w0 * c594 - c34,
        w0 * c595,
        w0 * c596,
        w0 * c597,
        w0 * c598,
        w0 * c599,
        w0 * c600 - c41,
    )
    dQ_hat_dq_i = ca.reshape(dQ_hat_dq_i, 5, 5)
    dQ_hat_dq_i = ca.densify(dQ_hat_dq_i)
    inputs, outputs = [q_d_dot, c], [dQ_hat_dq_i]
    return ca.Function("dQ_hat_dq_i", inputs, outputs, ["q_d_dot", "c"], ["dQ_hat_dq_i"])


def dQ_hat_dq_i_dot() -> ca.Function:
    """Total derivative of Q_hat by q_i_dot, through q_d_dot. 26 operations."""
    dQ_hat_dq_i_dot = ca.vertcat(
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
    )
    dQ_hat_dq_i_dot = ca.reshape(dQ_hat_dq_i_dot, 5, 5)
    dQ_hat_dq_i_dot = ca.densify(dQ_hat_dq_i_dot)
    inputs, outputs = [], [dQ_hat_dq_i_dot]
    return ca.Function("dQ_hat_dq_i_dot", inputs, outputs, [], ["dQ_hat_dq_i_dot"])


def dMa_dq_i() -> ca.Function:
    """Total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot. 26 operations."""
    dMa_dq_i = ca.vertcat(
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
    )
    dMa_dq_i = ca.reshape(dMa_dq_i, 5, 5)
    dMa_dq_i = ca.densify(dMa_dq_i)
    inputs, outputs = [], [dMa_dq_i]
    return ca.Function("dMa_dq_i", inputs, outputs, [], ["dMa_dq_i"])


def forward_dynamics() -> ca.Function:
    """q_i_ddot of a tree by topology-ordered elimination, without M_hat. 155 operations."""
    q_i = ca.SX.sym("q_i", 5)
    q_d_dot = ca.SX.sym("q_d_dot", 3)
    t = ca.SX.sym("t", 1)
    c = ca.SX.sym("c", 601)
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
    c35 = c[35]
    c36 = c[36]
    c37 = c[37]
    c38 = c[38]
    c39 = c[39]
    c40 = c[40]
    c41 = c[41]
    c42 = c[42]
    w0 = beam_theta_dot**2
    w1 = w0 * (beam_q1 * c0 - (beam_q1 * c5 + beam_q2 * c6 + beam_q3 * c7 + beam_q4 * c8 + beam_q5 * c9)) - beam_q1 * c10
    w2 = t < c11
    w3 = (1.0 - ca.cos(t * 6.283185307179586 / c11) * c14) * c13
    w4 = w0 * (beam_q2 * c1 - (beam_q1 * c15 + beam_q2 * c16 + beam_q3 * c17 + beam_q4 * c18 + beam_q5 * c19))
    w5 = w0 * (beam_q3 * c2 - (beam_q1 * c22 + beam_q2 * c23 + beam_q3 * c24 + beam_q4 * c25 + beam_q5 * c26))
    w6 = w0 * (beam_q4 * c3 - (beam_q1 * c29 + beam_q2 * c30 + beam_q3 * c31 + beam_q4 * c32 + beam_q5 * c33))
    w7 = w0 * (beam_q5 * c4 - (beam_q1 * c36 + beam_q2 * c37 + beam_q3 * c38 + beam_q4 * c39 + beam_q5 * c40))
    q_i_ddot = ca.vertcat(
        (w1 - ca.if_else(w2, w3 * c12, 0)) / c0,
        (w4 - beam_q2 * c20 - ca.if_else(w2, w3 * c21, 0)) / c1,
        (w5 - beam_q3 * c27 - ca.if_else(w2, w3 * c28, 0)) / c2,
        (w6 - beam_q4 * c34 - ca.if_else(w2, w3 * c35, 0)) / c3,
        (w7 - beam_q5 * c41 - ca.if_else(w2, w3 * c42, 0)) / c4,
    )
    q_i_ddot = ca.densify(q_i_ddot)
    inputs, outputs = [q_i, q_d_dot, t, c], [q_i_ddot]
    return ca.Function("forward_dynamics", inputs, outputs, ["q_i", "q_d_dot", "t", "c"], ["q_i_ddot"])


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
}
