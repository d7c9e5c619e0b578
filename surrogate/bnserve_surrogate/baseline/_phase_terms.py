"""Coefficients of the point-mass TaylorF2 phase through pseudo-5.5PN order, in powers of the symmetric mass ratio.

Through 3.5PN: Buonanno, Iyer, Ochsner, Pan, Sathyaprakash 2009 (arXiv:0907.0700), eq. (3.18). From 4PN to 5.5PN:
Messina, Dudi, Nagar, Bernuzzi 2019 (arXiv:1904.09558), the "quasi-5.5PN" phase. It is the PN expansion of the
effective-one-body dynamics and flux, exact in the test-mass limit; the coefficients that were not known analytically
(a_6^c, c_21^3PN, c_22^4PN, c_22^5PN there) are zero here. Every ``PHASE_<order>`` is a tuple of coefficients of
increasing powers of nu. They are evaluated once, in Python, because some numerators exceed 64 bits.
"""

from math import log, pi

EULER_GAMMA = 0.5772156649015328606
LOG_2 = log(2.0)
LOG_3 = log(3.0)

# arXiv:0907.0700, eq. (3.18)
PHASE_1PN = (3715 / 756, 55 / 9)
PHASE_1_5PN = -16 * pi
PHASE_2PN = (15293365 / 508032, 27145 / 504, 3085 / 72)
PHASE_2_5PN_LOG = (38645 / 252 * pi, -65 / 3 * pi)
PHASE_3PN = (
    11583231236531 / 4694215680 - 640 / 3 * pi**2 - 6848 / 21 * (EULER_GAMMA + 2 * LOG_2),
    -15737765635 / 3048192 + 2255 / 12 * pi**2,
    76055 / 1728,
    -127825 / 1296,
)
PHASE_3PN_LOG = -6848 / 21
PHASE_3_5PN = (77096675 / 254016 * pi, 378515 / 1512 * pi, -74045 / 756 * pi)

# arXiv:1904.09558. The 4PN term without a logarithm is linear in the frequency, hence dropped.
PHASE_4PN_LOG = (
    -3
    * (
        2550713843998885153 / 830425530654720
        - 90490 / 567 * pi**2
        - 36812 / 189 * EULER_GAMMA
        - 1011020 / 3969 * LOG_2
        - 26325 / 196 * LOG_3
    ),
    -3
    * (
        -5679872289503527 / 1281520880640
        - 5322928 / 3969 * EULER_GAMMA
        + 9302215 / 54432 * pi**2
        - 1420688 / 441 * LOG_2
        + 26325 / 49 * LOG_3
    ),
    -3 * (300600673165997 / 576684396288 - 399545 / 27216 * pi**2),
    -3 * 510041481025 / 13106463552,
    3 * 369469478275 / 16019011008,
)
PHASE_4PN_LOG_SQUARED = (9 * 18406 / 567, 9 * 2661464 / 11907)
PHASE_4_5PN = (
    pi * (105344279473163 / 18776862720 - 640 / 3 * pi**2 - 13696 / 21 * EULER_GAMMA - 27392 / 21 * LOG_2),
    pi * (-1492917260735 / 134120448 + 2255 / 6 * pi**2),
    pi * 45293335 / 127008,
    pi * 10323755 / 199584,
)
PHASE_4_5PN_LOG = -13696 / 21 * pi
# numerators over (1 - 3 nu)
PHASE_5PN = (
    -1433006523295407126559 / 126306697995878400
    + 578223115 / 3048192 * pi**2
    + 6470582647 / 27505170 * EULER_GAMMA
    + 53992839431 / 55010340 * LOG_2
    - 5512455 / 21952 * LOG_3,
    569935181259668744781113 / 10837114688046366720
    + 63787407527 / 9168390 * EULER_GAMMA
    - 5451429547 / 8128512 * pi**2
    + 159943397077 / 18336780 * LOG_2
    + 8924175 / 3136 * LOG_3,
    -18736399363805057301105217 / 365752620721564876800
    - 99239192119 / 4584195 * EULER_GAMMA
    + 415795517 / 903168 * pi**2
    - 117340379713 / 4584195 * LOG_2
    - 58330935 / 5488 * LOG_3,
    -857104076559310860540851 / 34289308192646707200
    - 6147793142 / 1528065 * EULER_GAMMA
    - 460519 / 1536 * pi**2
    - 43111797668 / 1528065 * LOG_2
    + 1279395 / 98 * LOG_3,
    11160810800663155149913 / 272137366608307200 - 9434797 / 18816 * pi**2,
    -12721434740371951621 / 676317715831296,
    2425066585102052979797 / 857232704816167680,
)
PHASE_5PN_LOG = (
    3 * 6470582647 / 82515510,
    -3 * 24279431641 / 27505170,
    3 * 13849493129 / 13752585,
    3 * 12863780362 / 4584195,
)
PHASE_5_5PN = (
    pi
    * (
        1857541407236594411 / 276808510218240
        - 94390 / 567 * pi**2
        - 3558011 / 7938 * EULER_GAMMA
        - 862549 / 1134 * LOG_2
        - 26325 / 196 * LOG_3
    ),
    pi
    * (
        -430383707398397047 / 34601063777280
        + 45015785 / 145152 * pi**2
        - 1346662 / 567 * EULER_GAMMA
        - 21009626 / 3969 * LOG_2
        + 26325 / 49 * LOG_3
    ),
    pi * (5120314955146397 / 629110250496 - 10647905 / 36288 * pi**2),
    -pi * 1080597828475 / 26212927104,
    pi * 657627073445 / 144171099072,
)
PHASE_5_5PN_LOG = (-pi * 3558011 / 7938, -pi * 1346662 / 567)
