; expect: residual=smoothing -residual=oversize -residual=insertRadius
0 BEGIN PGM CASE MM
1 BLK FORM CYLINDER Z D75 L100 DIST+0
2 FUNCTION MODE TURN
3 TOOL CALL 1
4 FUNCTION TURNDATA SPIN VCONST:ON VC:150 SMAX2500
5 M136
6 L X+160 Z+60 R0 FMAX M303
7 CYCL DEF 812 ABSATZ LAENGS ERW. ~
    Q215=+1 ;P ~
    Q460=+2 ;P ~
    Q491=+75 ;P ~
    Q492=+0 ;P ~
    Q493=+50.5 ;P ~
    Q494=-55.3 ;P ~
    Q495=+0 ;P ~
    Q501=+0 ;P ~
    Q502=+0.5 ;P ~
    Q500=+1.5 ;P ~
    Q496=+0 ;P ~
    Q503=+0 ;P ~
    Q504=+0.5 ;P ~
    Q463=+2.7 ;P ~
    Q478=+0.3 ;P ~
    Q483=+0 ;P ~
    Q484=+0 ;P ~
    Q505=+0.2 ;P ~
    Q506=+2 ;P
8 L X+75 Z+2 R0 FMAX
9 CYCL CALL
10 M30
11 END PGM CASE MM
