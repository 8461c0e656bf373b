import { typeset } from "../typography/typeset.ts";

/** What each kind of block does, the rule of the control for it, and what is often done wrong with it. */
export const blockKinds = typeset({
  begin: {
    about: "La première séquence : nom et unité du programme.",
    rule: "Le nom est celui du fichier.",
    mistakes: ["Le fichier est renommé et la séquence garde l’ancien nom."],
  },
  end: {
    about: "La dernière séquence. Ce qui suit n’est pas exécuté.",
    rule: "Nom et unité sont ceux de BEGIN PGM.",
    mistakes: ["M30 manque : broche et arrosage restent en marche à la fin."],
  },
  blankBox: {
    about:
      "Un pavé comme brut, par son plus petit coin (0.1) et son plus grand (0.2). Tourné, il vaut le " +
      "cylindre qui passe par ses coins.",
    rule: "0.1 nomme l’axe de broche ; 0.2 a la plus grande valeur sur chaque axe.",
    mistakes: ["Les coins sont inversés : le pavé n’a pas de volume."],
  },
  blankCylinder: {
    about: "La barre ou le disque à tourner : ⌀ ou rayon, longueur, distance de sa face à Z0, et un alésage.",
    rule: "Le brut ne sert qu’à la simulation ; la machine ne le connaît pas.",
    mistakes: ["Le brut est plus petit que le vrai : l’image montre de l’air là où la machine coupe."],
  },
  blankRotation: {
    about: "Un brut forgé ou coulé : un contour qui tourne autour de l’axe.",
    rule: "Le contour se trouve derrière un label ou dans un fichier, et compte selon son DIM.",
    mistakes: ["Le contour ne revient pas à l’axe : personne ne sait où finit la matière."],
  },
  blankFile: {
    about: "Un brut comme corps dans un fichier STL. Il est conservé et non simulé ici.",
    rule: "Le fichier se trouve à côté du programme ; TARGET nomme la pièce finie.",
    mistakes: ["Le fichier n’est pas emporté avec le programme."],
  },
  toolDefinition: {
    about: "Ancienne manière de donner longueur et rayon d’un outil dans le programme même.",
    rule: "Si l’outil est dans le tableau, TOOL DEF avec son seul numéro le prépare dans le changeur.",
    mistakes: ["Il sert pour des outils de tournage : ceux-ci demandent leur tableau."],
  },
  toolCall: {
    about:
      "Change l’outil, ou sans outil seulement vitesse, avance ou surépaisseurs. Ensuite personne ne sait où est " +
      "la pointe avant qu’elle soit positionnée.",
    rule: "Il met fin aux valeurs de FUNCTION TURNDATA CORR et à la correction de rayon.",
    mistakes: ["La première séquence qui suit ne nomme qu’un axe : l’autre vient de n’importe où."],
  },
  mode: {
    about:
      "Passe du tournage au fraisage et retour. En tournage X est un ⌀, et c’est la broche de la pièce qui tourne.",
    rule: "MODE TURN avant la première séquence de tournage ; la machine peut demander sa cinématique.",
    mistakes: ["Il manque : X compte comme rayon et les cycles de tournage sont refusés."],
  },
  spin: {
    about: "Vitesse de la pièce : vitesse de coupe constante avec une limite, ou un nombre de tours fixe.",
    rule: "Il vaut jusqu’au suivant. Il ne démarre pas la broche : M3 ou M4 le font.",
    mistakes: ["Il se trouve après la première coupe."],
  },
  turnCorrection: {
    about: "Allonge ou raccourcit l’outil dans le programme : une cote se corrige sans le tableau.",
    rule: "Il vaut jusqu’au prochain TOOL CALL.",
    mistakes: ["Le signe est inversé : plus de DXL agrandit un diamètre extérieur."],
  },
  turnBlank: {
    about:
      "Suivi de la pièce brute : la commande retient ce qui est coupé, pour qu’aucun cycle ne coupe à nouveau dans l’air.",
    rule: "Actif de BLANK à BLANK OFF ; le profil doit être fermé.",
    mistakes: ["Il reste actif pour le second serrage : l’ancien brut compte encore."],
  },
  L: {
    about: "Droite vers un point. Les axes absents ne bougent pas.",
    rule: "Avance, correction et fonctions M continuent de valoir.",
    mistakes: ["Un signe manque : Z25 est devant la pièce."],
  },
  LP: {
    about: "Droite vers un point donné par distance et angle depuis le pôle CC.",
    rule: "Une séquence CC précède.",
    mistakes: ["Un autre CC est entre les deux : le point est ailleurs."],
  },
  C: {
    about: "Arc autour du centre CC jusqu’à son point final.",
    rule: "Début et fin sont sur un même cercle autour de CC.",
    mistakes: ["Le point final n’est pas sur le cercle : la commande s’arrête sur une erreur."],
  },
  CP: {
    about: "Arc autour de CC jusqu’à un angle.",
    rule: "Le rayon est la distance du départ à CC.",
    mistakes: ["DR manque : l’arc part dans l’autre sens."],
  },
  CR: {
    about: "Arc vers un point par son rayon.",
    rule: "Quatre arcs conviennent : le signe de R et DR en choisissent un.",
    mistakes: ["Le rayon est plus petit que la moitié du trajet : cet arc n’existe pas."],
  },
  CT: {
    about: "Arc qui continue l’élément précédent sans coin.",
    rule: "Deux coordonnées, et un élément avant lui.",
    mistakes: ["Il suit un coin qui devait rester."],
  },
  CTP: {
    about: "Arc tangentiel vers un point donné depuis le pôle CC.",
    rule: "CC n’est pas un centre ici ; c’est de lui que l’on mesure.",
    mistakes: ["Le pôle est pris pour le centre de l’arc."],
  },
  CC: {
    about: "Centre de C et CP, et pôle de toutes les séquences polaires.",
    rule: "Il ne déplace rien et vaut jusqu’au CC suivant.",
    mistakes: ["X est saisi comme rayon en tournage ; c’est un ⌀."],
  },
  RND: {
    about: "Arrondit le coin entre la séquence précédente et la suivante, sans point final propre.",
    rule: "Il se trouve entre deux séquences de trajectoire du plan.",
    mistakes: ["La séquence suivante est trop courte pour le rayon."],
  },
  chamfer: {
    about: "Casse le coin entre deux droites de la même longueur des deux côtés.",
    rule: "Il se trouve entre deux droites.",
    mistakes: ["La longueur de la pente est saisie ; c’est celle le long de l’arête qu’il faut."],
  },
  free: {
    about: "Un élément d’un contour libre : autant que donne le dessin. Il est conservé et non exécuté ici.",
    rule: "La commande calcule les valeurs absentes à partir de tous les éléments.",
    mistakes: ["Aucun élément n’est assez défini : pas de solution."],
  },
  undercut: {
    about: "Un dégagement normalisé entre un cylindre et sa face. Les mots absents viennent de la norme.",
    rule: "Il se trouve dans le contour d’un cycle, entre les deux éléments.",
    mistakes: ["Il se trouve dans le programme principal : là il ne fait rien."],
  },
  groove: {
    about: "Une gorge dans la droite qui précède.",
    rule: "Elle se trouve dans le contour d’un cycle.",
    mistakes: ["Elle est plus large que la place de son élément."],
  },
  label: {
    about: "Un endroit que l’on peut appeler : sous-programme, répétition, contour. LBL 0 termine un sous-programme.",
    rule: "Chaque numéro ou nom une seule fois par programme.",
    mistakes: ["Le sous-programme est avant M30 : il s’exécute une fois de plus tout seul."],
  },
  call: {
    about: "Exécute ce qui suit un label, une ou plusieurs fois.",
    rule: "Sans REP jusqu’à LBL 0 ; avec REP à nouveau la partie qui précède.",
    mistakes: ["REP compte les répétitions : 3 exécute la partie quatre fois."],
  },
  jump: {
    about: "Continue à un label quand une comparaison est vraie.",
    rule: "Des deux côtés : nombres ou paramètres.",
    mistakes: ["Rien dans la boucle ne change le paramètre : elle ne finit jamais."],
  },
  raise: {
    about: "Arrête le programme avec une erreur de ce numéro.",
    rule: "Le constructeur de la machine dit quel texte y correspond.",
    mistakes: ["Il se trouve là où passe toute exécution."],
  },
  contour: {
    about: "Nomme les labels dont le prochain cycle tourne le contour.",
    rule: "Plusieurs labels à la suite forment une liste.",
    mistakes: ["Le label manque ou se trouve dans un autre fichier."],
  },
  cycleLine: {
    about: "Une ligne d’un ancien cycle. Sa première ligne porte .0.",
    rule: "Les lignes d’un cycle se suivent.",
    mistakes: ["Une ligne du milieu est effacée : le cycle lit la suivante à sa place."],
  },
  cycle: {
    about: "Un cycle conservé ici et non exécuté : ses valeurs restent telles quelles.",
    rule: "Il agit là où il est appelé, ou là où il se trouve.",
    mistakes: ["Son effet passe pour vérifié : à partir d’ici le rapport dit que non."],
  },
  cycleCall: {
    about: "Exécute le dernier cycle défini, d’où se trouve l’outil.",
    rule: "M99 dans une séquence de positionnement fait de même ; M89 le fait à chaque séquence jusqu’à M99.",
    mistakes: ["L’outil est dans la matière à l’appel."],
  },
  selectContour: {
    about: "Prend le contour du prochain cycle dans un fichier.",
    rule: "Le fichier se trouve à côté du programme.",
    mistakes: ["L’extension manque au nom."],
  },
  contourDefinition: {
    about: "Zones, îlots et évidements d’un contour en une séquence.",
    rule: "P est une zone, I un îlot, V un évidement.",
    mistakes: ["Un îlot précède la zone où il se trouve."],
  },
  declareContour: {
    about: "Donne un nom à un contour pour une formule de contours.",
    rule: "Il revient inchangé et n’est pas exécuté ici.",
    mistakes: ["Le nom est donné deux fois."],
  },
  contourFormula: {
    about: "Combine des contours déclarés : réunis, coupés, sans.",
    rule: "Il revient inchangé et n’est pas exécuté ici.",
    mistakes: ["Des parenthèses manquent : les signes comptent depuis la gauche."],
  },
  callProgram: {
    about: "Exécute un autre programme à cet endroit.",
    rule: "Après son END PGM, ce programme continue.",
    mistakes: ["M30 dans le programme appelé termine tout."],
  },
  selectProgram: {
    about: "Nomme le programme que CALL SELECTED PGM exécute.",
    rule: "Le nom peut se trouver dans un paramètre QS.",
    mistakes: ["Un autre est choisi entre les deux : c’est lui qui vaut."],
  },
  callSelected: {
    about: "Exécute le dernier programme choisi.",
    rule: "Un SEL PGM précède.",
    mistakes: ["Rien n’a été choisi."],
  },
  datum: {
    about: "Déplace le point zéro : la suite compte de là.",
    rule: "Il vaut jusqu’au suivant ; RESET l’annule.",
    mistakes: ["Il est encore actif dans la seconde moitié du programme."],
  },
  datumTable: {
    about: "Déplace le point zéro d’une ligne d’un tableau. Ce qui s’y trouve, personne ici ne le sait.",
    rule: "Le tableau doit être choisi.",
    mistakes: ["Un autre tableau est actif sur la machine."],
  },
  mirror: {
    about: "Inverse les coordonnées des séquences fraisées.",
    rule: "RESET, ou aucun axe, y met fin.",
    mistakes: ["Le fraisage en avalant devient en opposition."],
  },
  rotation: {
    about: "Tourne le plan des séquences fraisées autour du point zéro.",
    rule: "RESET y met fin.",
    mistakes: ["Le pôle tourne aussi."],
  },
  scale: {
    about: "Agrandit ou réduit les coordonnées fraisées.",
    rule: "RESET y met fin.",
    mistakes: ["Un pourcentage est saisi : 99 agrandit 99 fois."],
  },
  plane: {
    about: "Incline le plan d’usinage, ou le remet. L’usinage incliné n’est pas exécuté ici.",
    rule: "MOVE, TURN ou STAY disent ce que font les axes.",
    mistakes: ["Il n’est pas remis avant le tournage."],
  },
  assign: {
    about: "Donne une valeur à un paramètre Q, ou la calcule.",
    rule: "Q vaut dans tous les programmes, QL dans le sien, QR reste après l’arrêt.",
    mistakes: ["Un cycle se sert lui-même de ce paramètre."],
  },
  assignText: {
    about: "Met du texte dans un paramètre QS.",
    rule: "Les parties se joignent par ||.",
    mistakes: ["Les guillemets manquent."],
  },
  functions: {
    about: "Fonctions M sans trajectoire : broche, arrosage, unité de l’avance.",
    rule: "Les unes agissent avant le mouvement de leur séquence, les autres après.",
    mistakes: ["M136 manque avant la première avance par tour."],
  },
  stop: {
    about: "Arrête jusqu’à ce que l’on presse départ CN.",
    rule: "Broche et arrosage restent en marche si aucune fonction M ne dit autre chose.",
    mistakes: ["Il est dans la coupe : l’arête frotte à un seul endroit."],
  },
  comment: {
    about: "Des mots pour qui lit le programme.",
    rule: "Ils ne changent rien.",
    mistakes: ["Un commentaire donne des valeurs changées depuis."],
  },
  structure: {
    about: "Un titre dans la liste des parties du programme.",
    rule: "L’articulation de la commande le montre.",
    mistakes: ["Les parties sont déplacées et leurs titres restent."],
  },
});
