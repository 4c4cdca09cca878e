/* Written by etalon 0.1.0
 * campaign: PreXYT, geometry alone (synthetic)
 * robot: PreXYT
 * units: mm, deg and rad, 1_ u is the standard uncertainty (k = 1)
 * sha256 of parameters.json: a1eb7ee5cfa6487e370e1bb9836e8e395815a833b41d4f6fa4ea19fb22b59424
 * validation poses: nominal 0.20082 mm, identified 0.00984 mm, this file 0.00984 mm (rms)
 */
#ifndef ETALON_PREXYT_PARAMETERS_H
#define ETALON_PREXYT_PARAMETERS_H

/* beta: identified, u = 0.0021108354231101183 deg */
#define ETALON_PREXYT_BETA_DEG (-0.028858328965666993)
#define ETALON_PREXYT_BETA_RAD (-0.0005036728570745387)

/* gamma: identified, u = 0.0008488231308538987 deg */
#define ETALON_PREXYT_GAMMA_DEG 0.10572077752614768
#define ETALON_PREXYT_GAMMA_RAD 0.0018451756555997027

/* epsilon_theta: identified, u = 0.0006941140480957239 deg */
#define ETALON_PREXYT_EPSILON_THETA_DEG (-0.02166714225866244)
#define ETALON_PREXYT_EPSILON_THETA_RAD (-0.00037816297191166045)

/* s: identified, u = 0.008635371451029465 mm */
#define ETALON_PREXYT_S_MM 393.896281867263

/* d3: identified, u = 0.007901674606513762 mm */
#define ETALON_PREXYT_D3_MM 0.7370622790728306

/* d: identified, u = 0.009168550687750566 mm */
#define ETALON_PREXYT_D_MM 116.05888622690573

/* x_c: identified, u = 0.009362589946808704 mm */
#define ETALON_PREXYT_X_C_MM 73.00320519989033

/* y_c: identified, u = 0.0020524353513458895 mm */
#define ETALON_PREXYT_Y_C_MM (-73.01388819018788)

/* x_o: identified, u = 0.005357363176156149 mm */
#define ETALON_PREXYT_X_O_MM 23.36501244828332

/* y_o: identified, u = 0.004562356932361095 mm */
#define ETALON_PREXYT_Y_O_MM (-30.689900946399767)

/* delta: identified, u = 8.144376882053139e-6 ratio */
#define ETALON_PREXYT_DELTA_RATIO 0.9992019464498924

/* delta2: identified, u = 1.349967404217889e-5 ratio */
#define ETALON_PREXYT_DELTA2_RATIO 0.9995902823823095

/* delta3: identified, u = 1.3077289908998263e-5 ratio */
#define ETALON_PREXYT_DELTA3_RATIO 0.9997858776738159

/* l_kl: identified, u = 0.0014232572676786159 mm */
#define ETALON_PREXYT_L_KL_MM 146.0219196441708

#endif /* ETALON_PREXYT_PARAMETERS_H */
