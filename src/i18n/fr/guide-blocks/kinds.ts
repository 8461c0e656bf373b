import { typeset } from "../typography/typeset.ts";

/** Function of each kind of block, the rule of the control, and common mistakes. */
export const blockKinds = typeset({
  begin: {
    about: "La première séquence : nom et unité du programme.",
    rule: "Le nom du programme et celui du fichier doivent être identiques.",
    mistakes: ["Le fichier est renommé et la séquence garde l’ancien nom."],
  },
  end: {
    about: "La dernière séquence. Les suivantes ne sont pas exécutées.",
    rule: "Nom et unité sont ceux de BEGIN PGM.",
    mistakes: ["M30 manque : broche et arrosage restent en marche à la fin."],
  },
  blankBox: {
    about:
      "Pièce brute parallélépipédique, définie par le point MIN (0.1) et le point MAX (0.2). En tournage, elle " +
      "est traitée comme le cylindre passant par ses coins.",
    rule: "0.1 contient l’axe de broche ; 0.2 a la plus grande valeur sur chaque axe.",
    mistakes: ["Les points sont inversés : le parallélépipède n’a pas de volume."],
  },
  blankCylinder: {
    about: "Pièce brute cylindrique : ⌀ ou rayon, longueur, distance de la face à Z0 et alésage.",
    rule: "La pièce brute ne sert qu’à la simulation.",
    mistakes: ["Pièce brute plus petite que la réelle : la simulation montre du vide là où la machine usine."],
  },
  blankRotation: {
    about: "Pièce brute forgée ou moulée : un contour en rotation autour de l’axe.",
    rule: "Le contour est dans un label ou un fichier ; DIM définit les valeurs au diamètre ou au rayon.",
    mistakes: ["Le contour ne revient pas à l’axe : la fin de la matière n’est pas définie."],
  },
  blankFile: {
    about: "Pièce brute depuis un fichier STL. Conservée, non simulée.",
    rule: "Le fichier est dans le dossier du programme ; TARGET sélectionne la pièce finie.",
    mistakes: ["Le fichier n’est pas exporté avec le programme."],
  },
  toolDefinition: {
    about: "Ancienne définition de la longueur et du rayon d’outil dans le programme.",
    rule: "Si l’outil est dans le tableau, TOOL DEF avec son seul numéro le prépare dans le changeur.",
    mistakes: ["Utilisé pour des outils de tournage : ceux-ci exigent le tableau d’outils de tournage."],
  },
  toolCall: {
    about:
      "Change l’outil ; sans outil, seulement vitesse, avance ou surépaisseurs. La position de la pointe est " +
      "ensuite inconnue jusqu’au positionnement suivant.",
    rule: "TOOL CALL annule FUNCTION TURNDATA CORR et la correction de rayon.",
    mistakes: ["La séquence suivante n’a qu’un axe : l’autre position est indéfinie."],
  },
  mode: {
    about: "Commute entre tournage et fraisage. En tournage, X est un ⌀ et la broche de tournage est active.",
    rule: "MODE TURN avant la première séquence de tournage ; la machine peut exiger un nom de cinématique.",
    mistakes: ["La séquence manque : X est un rayon et les cycles de tournage sont refusés."],
  },
  spin: {
    about: "Vitesse de la broche de tournage : vitesse de coupe constante avec limite, ou vitesse fixe.",
    rule: "Valable jusqu’à la séquence SPIN suivante. Ne démarre pas la broche : programmer M3 ou M4.",
    mistakes: ["La séquence est après la première coupe."],
  },
  turnCorrection: {
    about: "Corrige la longueur d’outil dans le programme, sans le tableau d’outils.",
    rule: "Valable jusqu’au prochain TOOL CALL.",
    mistakes: ["Signe inversé : un DXL plus grand agrandit un diamètre extérieur."],
  },
  turnBlank: {
    about:
      "Actualisation de la pièce brute : la commande enregistre la matière enlevée, les cycles évitent les " +
      "passes à vide.",
    rule: "Actif de BLANK à BLANK OFF ; le profil doit être fermé.",
    mistakes: ["Active au second serrage : l’ancienne pièce brute s’applique encore."],
  },
  L: {
    about: "Droite vers un point. Les axes absents ne bougent pas.",
    rule: "Avance, correction et fonctions M sont modales.",
    mistakes: ["Un signe manque : Z25 est devant la pièce."],
  },
  LP: {
    about: "Droite vers un point défini par distance et angle depuis le pôle CC.",
    rule: "Exige une séquence CC avant.",
    mistakes: ["Un autre CC est entre les deux : le point change."],
  },
  C: {
    about: "Arc autour du centre CC jusqu’à son point final.",
    rule: "Début et fin sont sur un même cercle autour de CC.",
    mistakes: ["Le point final n’est pas sur le cercle : la commande s’arrête avec une erreur."],
  },
  CP: {
    about: "Arc autour de CC jusqu’à un angle.",
    rule: "Le rayon est la distance du départ à CC.",
    mistakes: ["DR manque : l’arc est dans l’autre sens."],
  },
  CR: {
    about: "Arc vers un point, défini par le rayon.",
    rule: "Quatre arcs sont possibles : le signe de R et DR en sélectionnent un.",
    mistakes: ["Rayon inférieur à la moitié de la distance : aucun arc possible."],
  },
  CT: {
    about: "Arc avec raccordement tangentiel à l’élément précédent.",
    rule: "Exige deux coordonnées et un élément précédent.",
    mistakes: ["Utilisé après un coin qui doit rester vif."],
  },
  CTP: {
    about: "Arc avec raccordement tangentiel vers un point défini depuis le pôle CC.",
    rule: "CC n’est pas le centre ici, mais le point de référence.",
    mistakes: ["Le pôle est pris pour le centre de l’arc."],
  },
  CC: {
    about: "Centre de C et CP, et pôle de toutes les séquences polaires.",
    rule: "Aucun déplacement ; valable jusqu’au CC suivant.",
    mistakes: ["X est saisi comme rayon en tournage ; c’est un ⌀."],
  },
  RND: {
    about: "Arrondit le coin entre la séquence précédente et la suivante, sans point final.",
    rule: "Seulement entre deux séquences de trajectoire du plan.",
    mistakes: ["La séquence suivante est trop courte pour le rayon."],
  },
  chamfer: {
    about: "Chanfrein entre deux droites, même longueur des deux côtés.",
    rule: "Seulement entre deux droites.",
    mistakes: ["La longueur de la pente est saisie ; il faut la longueur le long de l’arête."],
  },
  free: {
    about: "Élément d’un contour libre avec les valeurs du dessin. Conservé, non simulé.",
    rule: "La commande calcule les valeurs absentes à partir de tous les éléments.",
    mistakes: ["Trop peu de valeurs : pas de solution."],
  },
  undercut: {
    about: "Dégagement normalisé entre un cylindre et sa face. Les mots absents prennent les valeurs de la norme.",
    rule: "Seulement dans le contour d’un cycle, entre les deux éléments.",
    mistakes: ["Programmé dans le programme principal : sans effet."],
  },
  groove: {
    about: "Gorge dans la droite précédente.",
    rule: "Seulement dans le contour d’un cycle.",
    mistakes: ["La gorge est plus large que l’élément."],
  },
  label: {
    about:
      "Début d’un sous-programme, d’une répétition de partie de programme ou d’un contour. LBL 0 termine un " +
      "sous-programme.",
    rule: "Chaque numéro ou nom une seule fois par programme.",
    mistakes: ["Le sous-programme est avant M30 : il s’exécute une fois de plus sans appel."],
  },
  call: {
    about: "Exécute les séquences après un label, une ou plusieurs fois.",
    rule: "Sans REP : jusqu’à LBL 0. Avec REP : répétition de la partie.",
    mistakes: ["REP est le nombre de répétitions : 3 exécute la partie quatre fois."],
  },
  jump: {
    about: "Saute à un label si une condition est vraie.",
    rule: "Des deux côtés : nombres ou paramètres.",
    mistakes: ["Rien dans la boucle ne change le paramètre : elle ne finit jamais."],
  },
  raise: {
    about: "Arrête le programme avec une erreur de ce numéro.",
    rule: "Le constructeur de la machine définit le texte.",
    mistakes: ["Programmé là où passe toute exécution."],
  },
  contour: {
    about: "Sélectionne les labels du contour pour le cycle suivant.",
    rule: "Plusieurs labels à la suite forment une liste.",
    mistakes: ["Le label manque ou se trouve dans un autre fichier."],
  },
  cycleLine: {
    about: "Une ligne d’un ancien cycle. Sa première ligne porte .0.",
    rule: "Les lignes d’un cycle doivent se suivre.",
    mistakes: ["Une ligne est effacée : le cycle lit la suivante à sa place."],
  },
  cycle: {
    about: "Un cycle conservé, mais non simulé : ses valeurs ne changent pas.",
    rule: "Actif à son appel ou dès sa définition.",
    mistakes: ["Son effet est supposé vérifié : le programme est non vérifié à partir d’ici."],
  },
  cycleCall: {
    about: "Exécute le dernier cycle défini depuis la position actuelle de l’outil.",
    rule: "M99 dans une séquence de positionnement fait de même ; M89 appelle à chaque séquence jusqu’à M99.",
    mistakes: ["L’outil est dans la matière à l’appel."],
  },
  selectContour: {
    about: "Sélectionne un fichier avec le contour du cycle suivant.",
    rule: "Le fichier est dans le dossier du programme.",
    mistakes: ["L’extension du fichier manque."],
  },
  contourDefinition: {
    about: "Zones, îlots et évidements d’un contour en une séquence.",
    rule: "P est une zone, I un îlot, V un évidement.",
    mistakes: ["Un îlot précède sa zone."],
  },
  declareContour: {
    about: "Donne un nom à un contour pour une formule de contours.",
    rule: "Conservé inchangé, non simulé.",
    mistakes: ["Le nom est donné deux fois."],
  },
  contourFormula: {
    about: "Combine des contours déclarés : union, intersection, différence.",
    rule: "Conservé inchangé, non simulé.",
    mistakes: ["Des parenthèses manquent : les opérateurs s’appliquent de gauche à droite."],
  },
  callProgram: {
    about: "Exécute un autre programme à cet endroit.",
    rule: "Après son END PGM, ce programme continue.",
    mistakes: ["M30 dans le programme appelé termine tout."],
  },
  selectProgram: {
    about: "Sélectionne le programme pour CALL SELECTED PGM.",
    rule: "Le nom peut être un paramètre QS.",
    mistakes: ["Un autre est sélectionné entre les deux : celui-ci s’applique."],
  },
  callSelected: {
    about: "Exécute le dernier programme sélectionné.",
    rule: "Exige SEL PGM avant.",
    mistakes: ["Aucun programme sélectionné."],
  },
  datum: {
    about: "Décalage du point zéro : les coordonnées suivantes se rapportent au nouveau point zéro.",
    rule: "Valable jusqu’au décalage suivant ; RESET l’annule.",
    mistakes: ["Encore actif dans la seconde moitié du programme."],
  },
  datumTable: {
    about: "Décalage du point zéro par une ligne d’un tableau de points zéro. Le tableau n’est pas connu ici.",
    rule: "Le tableau doit être sélectionné.",
    mistakes: ["Un autre tableau est actif sur la machine."],
  },
  mirror: {
    about: "Image miroir des coordonnées des séquences fraisées.",
    rule: "RESET, ou aucun axe, annule l’image miroir.",
    mistakes: ["Le fraisage en avalant devient en opposition."],
  },
  rotation: {
    about: "Tourne le plan des séquences fraisées autour du point zéro.",
    rule: "RESET l’annule.",
    mistakes: ["Le pôle tourne aussi."],
  },
  scale: {
    about: "Agrandit ou réduit les coordonnées fraisées.",
    rule: "RESET l’annule.",
    mistakes: ["Un pourcentage est saisi : 99 agrandit 99 fois."],
  },
  plane: {
    about: "Incline le plan d’usinage ou le réinitialise. L’usinage incliné n’est pas simulé.",
    rule: "MOVE, TURN ou STAY définissent le mouvement des axes.",
    mistakes: ["Le plan n’est pas réinitialisé avant le tournage."],
  },
  assign: {
    about: "Affecte ou calcule un paramètre Q.",
    rule: "Q est valable dans tous les programmes, QL dans un programme, QR est conservé après l’arrêt.",
    mistakes: ["Un cycle utilise ce paramètre."],
  },
  assignText: {
    about: "Affecte du texte à un paramètre QS.",
    rule: "Les parties se joignent par ||.",
    mistakes: ["Les guillemets manquent."],
  },
  functions: {
    about: "Fonctions M sans déplacement : broche, arrosage, unité de l’avance.",
    rule: "Certaines agissent avant le mouvement de la séquence, d’autres après.",
    mistakes: ["M136 manque avant la première avance par tour."],
  },
  stop: {
    about: "Arrêt du programme jusqu’à Start CN.",
    rule: "Broche et arrosage restent en marche sauf si une fonction M les modifie.",
    mistakes: ["Programmé dans la coupe : l’arête frotte à un seul endroit."],
  },
  comment: {
    about: "Texte pour le lecteur du programme.",
    rule: "Sans effet sur l’usinage.",
    mistakes: ["Le commentaire contient des valeurs périmées."],
  },
  structure: {
    about: "Article d’articulation du programme.",
    rule: "L’articulation de la commande l’affiche.",
    mistakes: ["Des séquences sont déplacées sans leur article d’articulation."],
  },
});
