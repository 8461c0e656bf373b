import type { MessagesTexts } from "../../message-texts.ts";
import { running } from "./messages/running.ts";
import { threads } from "./messages/threads.ts";

/** What a finding offers, where it offers something. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Valeur possible la plus proche : ${say(value)}.`;
const count = (n: number, one: string, many: string) => `${n} ${n < 2 ? one : many}`;

const reasons: MessagesTexts["reasons"] = {
  insertRadius: "rayon de plaquette",
  mainEdge: "arête principale",
  secondaryEdge: "arête secondaire",
  toolWidth: "largeur de l’outil",
  cutLength: "CUTLENGTH",
  limit: "limite d’usinage",
  plunging: "plongée non autorisée",
  oversize: "surépaisseur",
  smoothing: "marches entre les passes",
  correction: "correction de l’outil",
  overCrest: "matière au-dessus du sommet du filet",
};

const ELEMENT = { angle: "angle", length: "longueur", radius: "rayon" };

/** What holds the work. */
const CLAMPED = {
  jaws: "les mors",
  chuck: "le mandrin",
  collet: "la pince",
  driver: "l’entraîneur",
  tailstock: "la contre-poupée",
  limit: "la limite indiquée",
};

export const messages = {
  reasons,
  morePlaces: (place, more) => `${place} et à ${more === 1 ? "un autre endroit" : `${more} autres endroits`}`,
  of: {
    ...running,
    ...threads,
    missing: () => "Saisir une valeur.",
    notANumber: (d, w) => `« ${w.text(d.text)} » n’est pas un nombre.`,
    badExpression: (d, w) => `« ${w.text(d.text)} » ne peut pas être calculé.`,
    unknownParameter: (d) => `${d.name} n’a pas de valeur ici. Saisir un nombre.`,
    outOfRange: (d, w) =>
      `${w.value(d.value)} est hors de la plage ${w.value(d.min)} à ${w.value(d.max)}.${nearest(d.nearest, w.value)}`,
    notWhole: (d, w) => `${w.number(d.value)} n’est pas un nombre entier.${nearest(d.nearest, w.number)}`,
    notAChoice: (d, w) =>
      `${w.number(d.value)} n’est pas un des choix ${d.choices.join(", ")}.${nearest(d.nearest, w.number)}`,
    startEqualsEnd: (d, w) => `Départ et fin sont identiques : ${d.other} vaut aussi ${w.value(d.value)}.`,
    startLevelWithEnd: (d, w) =>
      `Le point de départ est à ${d.axis} ${w.size(d.value)}, là où finit le contour : entre les deux, il n’y a rien à usiner.`,
    diameterNegative: (d, w) =>
      `${w.value(d.value)} est un diamètre au-delà de l’axe, où aucun contour n’est calculé.${nearest(d.nearest, w.value)}`,
    elementTooLong: (d, w) => `${w.size(d.size)} est plus long que l’élément ne le permet : ${w.size(d.max)} au plus.`,
    cornersTooWide: (d, w) =>
      `Deux rayons de coin de ${w.size(d.radius)} dépassent la largeur du fond : ${w.size(d.max)} au plus.` + ``,
    wallsMeet: (d, w) =>
      `Avec ${w.angle(d.angle)}, les flancs se rejoignent au-dessus du fond : moins de ${w.angle(d.max)}.`,
    cornerSmallerThanInsert: (d, w) =>
      `Le rayon de coin ${w.size(d.radius)} est inférieur à celui de la plaquette, ${w.size(d.insert)} : le ` +
      `coin gardera ${w.size(d.insert)}.`,
    recessNarrowerThanTool: (d, w) =>
      `Le fond de la gorge est large de ${w.size(d.width)}, l’outil et la surépaisseur demandent ` +
      `${w.size(d.tool)}.${nearest(d.nearest, w.value)}`,
    angleNotFollowed: (d, w) =>
      `${d.element === undefined ? "L’" : `Élément ${d.element} : l’`}outil ne peut pas suivre ${w.angle(d.angle)} : l’${
        reasons[d.edge]
      } permet ${w.angle(d.max)}, de la ` + `matière reste.`,
    tooManyPasses: (d, w) => `${d.passes} passes, c’est plus que ${d.most}.${nearest(d.nearest, w.size)}`,
    infeedOverCutLength: (d, w) =>
      `La passe ${w.size(d.infeed)} dépasse CUTLENGTH ${w.size(d.cutLength)} : elle est réduite à ${w.size(d.cutLength)}.`,
    depthOverCutLength: (d, w) =>
      `La profondeur ${w.size(d.depth)} dépasse CUTLENGTH ${w.size(d.cutLength)} : de la matière reste.`,
    offsetReduced: (d, w) =>
      `Le décalage ${w.size(d.offset)} est réduit à ${w.size(d.kept)} : ` +
      `${count(d.passes, "passe se partage", "passes se partagent")} 80 % de la largeur effective.`,
    offsetOverLimit: (d, w) =>
      `Le décalage latéral de ${count(d.passes, "passe", "passes")} atteint ${w.size(d.offset)} ; 80 % de la ` +
      `largeur effective font ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
    toolUnfit: (d) =>
      `Un outil ${d.type} d’orientation ${d.orientation} ne convient pas. Prendre ${d.types.join(" ou ")} avec ` +
      `l’orientation ${d.orientations.join(", ")}.`,
    toolCannotCutSideways: (d) =>
      `Un outil ${d.type} ne fait que plonger, ce cycle coupe aussi latéralement. Prendre un outil RECTURN.`,
    flanksNotChecked: () => "T-ANGLE ou P-ANGLE est vide : les flancs de la plaquette ne sont pas contrôlés.",
    toolColumn: (d, w) => {
      const what =
        d.value === null
          ? `${d.column} manque ou n’est pas un nombre.`
          : `${d.column} ${w.value(d.value)} n’est pas possible.`;
      if (d.min !== undefined && d.max !== undefined) return `${what} Permis : ${w.value(d.min)} à ${w.value(d.max)}.`;
      if (d.min !== undefined)
        return `${what} La valeur doit être ${d.column === "CUTWIDTH" ? "supérieure à" : "au moins"} ${w.value(d.min)}.`;
      return d.max === undefined ? what : `${what} La valeur doit être inférieure à ${w.value(d.max)}.`;
    },
    toolNumberTwice: (d) => `L’outil ${d.number} est déjà dans le tableau.${nearest(d.nearest, String)}`,
    toolName: (d, w) =>
      `« ${w.text(d.text)} » : un nom a au plus ${d.max} caractères, en majuscules, chiffres et # $ % & , - . _ seulement.`,
    holderAxis: (d, w) => `« ${w.text(d.text)} » : le corps est placé suivant X ou suivant Z.`,
    holderHead: (d, w) =>
      `« ${w.text(d.text)} » n’est pas un contour. Chaque coin s’écrit Z/X depuis la pointe, avec un espace ` +
      "entre les coins et un point-virgule entre les parties ; une partie a au moins trois coins.",
    betterTool: (d) => `L’outil ${d.tool} ${d.name} peut réaliser ce contour.`,
    startInArea: (d, w) =>
      `Le point de départ ${w.place(d.x, d.z)} est dans la zone à usiner : l’outil va d’abord à la distance d’approche.`,
    startInMaterial: (d, w) => `Le point de départ ${w.place(d.x, d.z)} est dans la matière.`,
    startBelowContour: (d, w) =>
      `Le point de départ est ${w.length(d.below)} sous le début du contour : l’outil s’y rend d’abord.`,
    startBehindContour: (d, w) =>
      `Le point de départ est ${w.length(d.behind)} derrière le début du contour : l’outil va d’abord en Z à la distance d’approche de ${w.size(
        d.clearance,
      )} devant.`,
    startInPart: (d, w) =>
      `Le point de départ est dans la pièce finie : rien n’est usiné de là. Un point de départ possible : ${w.place(d.x, d.z)}.`,
    insertAcrossAxis: (d, w) =>
      `La plaquette dépasse l’axe de ${w.length(d.reach)} et y entame la pièce finie.` +
      (d.nearest === undefined
        ? " Elle est trop longue pour cet alésage."
        : ` Avec un point de départ à partir de X${w.diameter(d.nearest)}, elle reste dégagée.`),
    boreMissing: (d, w) =>
      `L’alésage manque : la matière est pleine à partir de Z${w.signed(d.z)}, le cycle va jusqu’à Z${w.signed(
        d.to,
      )}. Percer d’abord jusque-là à ${w.diameter(d.need)} au moins.`,
    startOnWrongSide: (d, w) =>
      `Le contour se dirige vers le point de départ : rien n’est usiné de ce côté. Un point de départ possible : ${w.place(d.x, d.z)}.`,
    startInsideEnvelope: (d, w) =>
      `Le point de départ est plus près du contour que la distance ${w.size(d.clearance)} : l’outil va droit ` +
      "au contour à l’avance de finition.",
    limitOnWrongSide: (d, w) =>
      `Avec la limite ${w.value(d.limit)}, rien n’est usiné du côté de l’outil.${nearest(d.nearest, w.value)}`,
    cutBehindLimit: (d, w) =>
      `Derrière la limite, ${w.area(d.area)} de matière sont enlevés en ${w.place(
        d.x,
        d.z,
      )} : seul le contour est limité, pas l’approche ni la sortie.` +
      (d.finishing
        ? " L’ébauche seule (Q215 = 1) la laisse."
        : " Placez la limite là où elles ne trouvent pas de matière."),
    nothingToCut: () => "Entre le point de départ et le contour, il n’y a rien à usiner.",
    contourMissing: (d, w) =>
      d.label === "" ? "Le contour manque." : `Le contour LBL ${w.text(d.label)} n’existe pas.`,
    contourTooShort: () => "Un contour demande au moins deux points différents.",
    contourFlat: (d) => `Début et fin du contour ont le même ${d.axis} : il n’y a rien à usiner entre eux.`,
    contourEndCovered: (d, w) =>
      `Le contour finit en ${w.place(
        d.x,
        d.z,
      )} à l’intérieur de lui-même : un de ses éléments dépasse cette fin, la pièce ne peut continuer.`,
    contourPoint: (d) => `Élément ${d.element} : le point final manque ou ne peut pas être atteint.`,
    cornerElementAlone: (d) =>
      `Élément ${d.element} : un chanfrein ou un arrondi demande un élément avant et après, un chanfrein deux droites.`,
    cornerElementTooLong: (d, w) =>
      `Élément ${d.element} : ${w.size(d.size)} ne tient pas entre ses voisins : ${w.size(d.max)} au plus.` + ``,
    arcOffCircle: (d, w) => `Élément ${d.element} : le point final manque son cercle de ${w.size(d.gap)}.`,
    arcTooSmall: (d, w) => `Élément ${d.element} : le rayon ${w.size(d.radius)} est trop petit pour le point final.`,
    elementFree: (d) =>
      d.freedom === 1
        ? `Élément ${d.element} : il manque une valeur.`
        : `Élément ${d.element} : il manque ${d.freedom} valeurs.`,
    elementContradicts: (d, w) =>
      d.quantity === "tangent"
        ? `L’élément ${d.element} ne se raccorde pas tangentiellement ; l’écart est de ${w.number(d.nearest)}°.`
        : `Élément ${d.element} : ${ELEMENT[d.quantity]} ${(d.quantity === "angle" ? w.number : w.size)(
            d.given,
          )} contredit les autres valeurs ; ` + `${(d.quantity === "angle" ? w.number : w.size)(d.nearest)} convient.`,
    elementUnreachable: (d) =>
      `Élément ${d.element} : avec cette longueur, ce rayon ou cet angle, il n’atteint pas son voisin.`,
    centreMissing: (d) => `Élément ${d.element} : le centre manque ; placer CC avant.`,
    contourCrossesItself: (d) => `L’élément ${d.element} croise l’élément ${d.other}.`,
    toolRadiusTooLarge: (d, w) =>
      `Élément ${d.element} : un rayon d’outil de ${w.size(d.radius)} ne passe pas.${nearest(d.nearest, w.size)}`,
    pathCutsContour: (d, w) =>
      `Le long de l’élément ${d.element}, l’outil entame l’élément ${d.other} de ${w.length(d.depth)} en ${w.spot(
        d.x,
        d.y,
        undefined,
      )} : il ne passe ` + `pas ; la commande ne compare que les voisins.${nearest(d.nearest, w.size)}`,
    approachNeedsSide: () => "CT demande RL ou RR : avec R0, la commande s’arrête ici.",
    approachSideAssumed: () =>
      "R0 ne dit pas de quel côté : l’outil est supposé venir de la gauche du contour. À vérifier sur la commande.",
    approachInsideCircle: (d, w) =>
      `${d.point} est à l’intérieur du cercle de R ${w.size(d.radius)} : aucune droite ne le touche depuis ce ` +
      `point.${nearest(d.nearest, w.size)}`,
    approachCutsContour: (d, w) =>
      `Entre ${d.point} et le contour, l’outil l’entame de ${w.length(d.depth)} en ${w.spot(d.x, d.y, d.z)} ` +
      `; la commande ne le contrôle pas. ${d.point} libre : ${w.spot(d.freeX, d.freeY, d.freeZ)}.`,
    approachValueCutsContour: (d, w) =>
      `Entre ${d.point} et le contour, l’outil l’entame de ${w.length(d.depth)} en ${w.spot(d.x, d.y, d.z)} ` +
      `; la commande ne le contrôle pas. Libre avec ${d.word} ${w.size(d.nearest)}.`,
    approachBlocked: (d, w) =>
      `Entre ${d.point} et le contour, l’outil l’entame de ${w.length(d.depth)} en ${w.spot(d.x, d.y, d.z)} ` +
      "; la commande ne le contrôle pas.",
    undercutNeighbours: (d) =>
      `Élément ${d.element} : un dégagement demande un cylindre parallèle à l’axe et une face perpendiculaire, une gorge un ` +
      "élément droit de sa direction.",
    recessWord: (d) => `Élément ${d.element} : ${d.word} manque ou ne donne aucune forme possible.`,
    recessWordsExclusive: (d) => `Élément ${d.element} : ${d.other} et ${d.word} s’excluent. N’en indiquer qu’un.`,
    pitchNotListed: (d, w) => {
      const near = [d.below, d.above].flatMap((n) => (n === undefined ? [] : [w.size(n, 4)])).join(" et ");
      return `Élément ${d.element} : DIN 76 ne donne pas de dégagement pour un pas de ${w.size(
        d.pitch,
        4,
      )} ; les pas voisins sont ${near}. En prendre un, ou écrire ${d.words}.`;
    },
    undercutDefaults: (d) =>
      `Élément ${d.element} : ${d.words} repris de la norme, non imprimé pour cette commande. Mieux vaut les programmer.`,
    materialLeft: (d, w) =>
      d.asked === undefined
        ? `Il reste ${w.area(d.area)} en ${w.place(d.x, d.z)}. Cause : ${reasons[d.reason]}.`
        : d.reason === "oversize"
          ? `Il reste ${w.area(d.area)} de surépaisseur en ${w.place(d.x, d.z)}, comme demandé.`
          : `L’angle en ${w.place(d.x, d.z)} a le rayon de la plaquette : il reste ${w.area(d.area)}. Aucun autre rayon n’est demandé.`,
    gouge: (d, w) => `${w.area(d.area)} de la pièce finie sont enlevés en ${w.place(d.x, d.z)}.`,
    rapidInStock: (d, w) => `Un rapide traverse ${w.area(d.area)} de matière en ${w.place(d.x, d.z)}.`,
    holderContact: (d, w) => `Le porte-outil touche la matière en ${w.place(d.x, d.z)}.`,
    cutBelowContour: (d, w) =>
      `Cette passe descend de ${w.area(d.area)} sous le contour du cycle de la séquence ${d.block}, en ${w.place(
        d.x,
        d.z,
      )}. Si elle est voulue, confirmez-la.`,
    cameLoose: (d, w) =>
      `${{ piece: "Un morceau", ring: "Un anneau", slug: "Une débouchure" }[d.shape]} de ${w.area(d.area)} en ${w.place(
        d.x,
        d.z,
      )} n'est plus relié ` + `à l'extrémité serrée : la séquence ${d.block} le détache.`,
    partedOff: (d, w) =>
      `La pièce en ${w.place(d.x, d.z)}, ${w.area(d.area)}, est tronçonnée à la séquence ${d.block} et quitte l'image.`,
    cutOnLoosePiece: (d, w) =>
      `En ${w.place(d.x, d.z)}, ${w.area(
        d.area,
      )} seraient usinés sur un morceau détaché par la séquence ${d.block} : plus rien ne le tient.`,
    behindBlank: (d, w) =>
      d.motion === "unheld"
        ? `L'extérieur est tourné jusqu'à l'extrémité arrière de la pièce brute en Z${w.size(
            d.rear,
          )} : il ne reste rien à serrer. Indiquez le serrage si elle est tenue autrement.`
        : `${d.motion === "rapid" ? "Un rapide passe" : "L'outil usine"} derrière l'extrémité arrière de la pièce brute en Z${w.size(
            d.rear,
          )}, en ${w.place(d.x, d.z)} : le moyen de serrage s'y trouve.`,
    clampContact: (d, w) =>
      `${d.by === "tool" ? "L’outil" : "Le porte-outil"} heurte ${CLAMPED[d.part]} en ${w.place(
        d.x,
        d.z,
      )}. Terminer la passe avant ou serrer autrement.`,
    contactsUnlooked: (d) =>
      `${d.limit} déplacements entament la pièce, entrent en rapide dans la matière ou la touchent avec le porte-outil : à ` +
      "partir d’ici, cela n’a plus été recherché.",
    deeperThanInfeed: (d, w) =>
      "" +
      (d.pass === undefined ? "Une passe de lissage ou de finition" : `La passe ${w.number(d.pass)}`) +
      ` prend ${w.length(d.depth)} de matière d’un coup ; ${w.length(d.allowed)} sont permis.`,
    blankLacks: (d, w) =>
      `${w.text(d.what)} omet ${w.area(d.area)} de la matière qui s’y trouve d’après le programme. C’est ce contour qui compte.`,
    blankGone: (d, w) =>
      `${w.text(d.what)} décrit ${w.area(d.area)} là où il n’y a plus rien. Ce qui est enlevé reste enlevé.`,
    nothingCut: () => "Cette opération n’enlève pas de matière.",
    airPasses: (d) =>
      d.count === 1 ? "1 passe ne touche pas de matière." : `${d.count} passes ne touchent pas de matière.`,

    notUnderstood: (d, w) => `« ${w.text(d.text)} » n’est pas compris : conservé, non simulé.`,
    wordNotUnderstood: (d, w) => `Le mot « ${w.text(d.text)} » n’est pas compris.`,
    wordTwice: (d, w) => `${w.text(d.word)} figure deux fois dans cette séquence ; le dernier compte.`,
    equalsMissing: (d, w) => `« ${w.text(d.text)} » n’a pas de signe égal. Il est lu comme s’il y était.`,
    blankBeforeEquals: (d, w) => `« ${w.text(d.text)} » a un espace avant le signe égal.`,
    badNumber: (d, w) => `« ${w.text(d.text)} » n’est pas un nombre.`,
    wordMissing: (d, w) => `${w.text(d.word)} manque dans cette séquence.`,
    blockNumber: (d) => `Le numéro de séquence ${d.found} ne suit pas ; ce serait ${d.expected}.`,
    blockNumberMissing: (d) => `La séquence n’a pas de numéro ; ce serait ${d.expected}.`,
    listWithoutTilde: (d) =>
      `${d.places === 1 ? "Il manque le ~ en fin de ligne dans une liste" : `Il manque le ~ en fin de ligne dans ${d.places} listes`} ` +
      "de cycle : une commande ne chargerait pas le programme.",
    continuationOpen: () => "La ligne finit par ~, mais aucune suite n’est là.",
    isoProgram: () => "Le texte est en DIN/ISO. L’ouvrir comme programme à part : il est alors traduit en Klartext.",
    frameMissing: (d) => `Il manque ${d.which} au programme.`,

    notSimulated: (d, w) => `${w.text(d.what)} : conservé, non simulé.`,
    notProved: (d, w) =>
      `${w.text(d.what)} n’est pas simulé et peut modifier la trajectoire ou le brut : à partir d’ici, rien n’est contrôlé.`,
    cycleNotSimulated: (d, w) => `Cycle ${d.cycle} ${w.text(d.name)} : conservé, non simulé.`,
    noCycleDefined: () => "Aucun cycle n’est défini avant l’appel.",
    noToolCalled: () => "Aucun outil n’est appelé avant cette séquence.",
    toolUnknown: (d, w) => `L’outil ${w.text(d.tool)} n’est pas dans le tableau.`,
    notInTurnMode: () => "Le cycle ne s’exécute qu’en FUNCTION MODE TURN : programmer cette séquence avant l’appel.",
    compensationActive: (d) =>
      `${d.side} est actif ici, or la commande exige R0 : programmer R0 dans la séquence de positionnement précédente.`,
    feedZero: (d, w) =>
      `${w.text(d.word)} : l’avance de coupe est de 0 ici. Indiquer une avance supérieure à 0 ; FAUTO prend le F de TOOL CALL.`,
    feedUnlikely: (d, w) =>
      `Une avance de ${w.number(d.feed)} ${d.unit} est peu vraisemblable. Vérifier M136 : avec lui, F compte en mm par tour.`,
    drillTooShort: (d, w) =>
      `Le trou a ${w.size(d.depth)} de profondeur, les arêtes du foret (LCUTS) ${w.size(d.edges)} : la queue peut frotter.`,
    pitchOfTap: (d, w) => `Q239 vaut ${w.size(d.pitch)}, mais le taraud du tableau a un PITCH de ${w.size(d.tap)}.`,
    freeChosen: () =>
      "À partir d’ici, plusieurs contours conviennent aux données : le plus court est montré. La commande prend celui que FSELECT désigne.",
    freeUnsolved: (d, w) =>
      `${w.text(d.form)} : les données ne déterminent pas cet élément ou se contredisent. Donner d’autres valeurs, ou FSELECT.`,
    cycleNeverCalled: (d) => `Le cycle ${d.cycle} est défini et jamais appelé : il manque CYCL CALL ou M99 ensuite.`,
    neverReached: (d) => `Le programme se termine avec ${d.by}, avant cette séquence : elle n’est jamais exécutée.`,
    listOfOlderSoftware: (d, w) =>
      `La liste du cycle ${d.cycle} vient d’un logiciel plus ancien. La commande la complète : ${d.filled
        .map((word) => w.text(word))
        .join(", ")}.`,
    parameterForeign: (d, w) =>
      `${w.text(d.name)} n’a pas sa place ici : le cycle ${d.cycle} n’a pas ce paramètre, ou il figure deux fois.`,
    runsIntoLabel: (d, w) => `Le programme continue dans le contour de LBL ${w.text(d.label)} : il manque M30 avant.`,
    contourStartIncomplete: (d) => `La première séquence du contour a besoin de X et de Z ; il manque ${d.axis}.`,
    approachUncompensated: (d) =>
      `${d.form} n’a ni RL ni RR : le contour qui suit est exécuté sans correction de rayon.`,
    labelMissing: (d, w) => `LBL ${w.text(d.label)} n’existe pas.`,
    labelTwice: (d, w) => `LBL ${w.text(d.label)} figure deux fois dans le programme.`,
    labelNotClosed: (d, w) => `LBL ${w.text(d.label)} n’est pas fermé par LBL 0.`,
    contourNotNamed: (d) => `Le cycle ${d.cycle} demande, avant l’appel, le cycle 14 avec son contour.`,
    contoursJoined: (d, w) =>
      `${w.text(d.joined)} : plusieurs contours en font ici un seul. Le cycle ${w.number(
        d.cycle,
      )} en prend un ; sa trajectoire n’est pas montrée.`,
    errorRaised: (d, w) =>
      d.error === null
        ? "FN 14 : la commande s’arrête ici sur une erreur ; rien n’est exécuté après."
        : `FN 14 : la commande s’arrête ici sur l’erreur ${w.number(d.error)} ; rien n’est exécuté après.`,
    contourInFile: (d, w) =>
      `Le contour est dans le fichier ${w.text(d.file)}, absent ici : le placer dans un label et le nommer avec le cycle 14.`,
    feedMissing: () => "Aucune avance n’est programmée.",
    spindleMissing: () => "Aucune vitesse de broche n’est programmée ; les temps manquent.",
    parameterUnset: (d) => `${d.name} n’a pas de valeur ici.`,
    divisionByZero: () => "Division par zéro.",
    notFinite: (d, w) => `« ${w.text(d.text)} » ne donne pas de nombre utilisable.`,
    clampingUnread: (d, w) => `CLAMPING : « ${w.text(d.what)} » n’est pas compris et ne compte pas.`,
    clampingIncomplete: (d) =>
      `CLAMPING ne compte pas : ${d.words} manque ou est impossible. Rien n’est connu du serrage.`,
    clampingTwice: () => "CLAMPING figure deux fois : le premier compte. Effacer celui-ci.",
    clampingMisses: (d, w) =>
      `Le serrage ne tient pas la pièce brute : aucune surface de ${w.diameter(
        d.diameter,
      )} dans la prise. Vérifier ⌀, longueur et face de CLAMPING.`,
    blankMissing: () => "Le programme n’indique pas de brut.",
    blankNotTurned: (d, w) => `Un brut de forme ${w.text(d.form)} n’est pas un corps de révolution autour de l’axe.`,
    endsExchanged: (d, w) =>
      d.axis === "X"
        ? `De X${w.diameter(d.start)} à X${w.diameter(d.end)}, il n’y a pas de matière à usiner. Début et fin (${d.other}) intervertis ?`
        : `De Z${w.signed(d.start)} à Z${w.signed(d.end)}, il n’y a pas de matière à usiner. Début et fin (${d.other}) intervertis ?`,
    endInFront: (d, w) => `Z${w.signed(d.value)} est devant la pièce. ${w.signed(d.nearest)} ?`,
    blankAgainstContour: (d, w) =>
      ({
        outside: `Le contour va jusqu’à ${w.diameter(d.contour)}, le brut seulement jusqu’à ${w.diameter(d.blank)}. Proposé : ${w.diameter(
          d.nearest,
        )}.`,
        bore: `L’alésage du brut est de ${w.diameter(d.blank)}, le contour finit à ${w.diameter(d.contour)} : rien n’est usiné. Proposé : ${w.diameter(
          d.nearest,
        )}.`,
        length: `Le contour va jusqu’à Z${w.signed(d.contour)}, le brut seulement jusqu’à Z${w.signed(d.blank)}. Proposé : ${w.size(
          d.nearest,
        )}.`,
        allowance: `Le contour commence à Z${w.signed(d.contour)}, le brut à Z${w.signed(d.blank)} : passes à vide. Proposé : ${w.signed(
          d.nearest,
        )}.`,
        thread: `Le filet a ${w.diameter(d.contour)}, le brut ${w.diameter(d.blank)}. Proposé : ${w.diameter(d.nearest)}.`,
      })[d.place],
    blankImpossible: () => "Le brut n’a pas de volume : vérifier ses cotes.",
    boxTurned: (d, w) =>
      `Le parallélépipède tourne comme le cylindre autour de ses coins, diamètre ${w.size(d.outer)}. La matière n’est sûre tout autour ` +
      `que jusqu’au diamètre ${w.size(d.inner)}. Une barre ronde est un BLK FORM CYLINDER.`,
    blankTaken: (d, w) => `${w.text(d.what)} sert de brut.`,
    blankAdds: (d, w) =>
      `${w.text(d.what)} décrit ${w.area(d.area)} de plus que BLK FORM. C’est ce contour qui compte.`,
    blankTraced: () =>
      "Tant que le brut est actualisé, l’ébauche omet les niveaux qui ne touchent rien. " +
      "Les autres trajets à vide, que la commande peut raccourcir, sont montrés en entier.",
    poleMissing: () => "La séquence demande un pôle CC avant elle.",
    startUnknown: () => "La position avant cette séquence n’est pas connue.",
    arcImpossible: () => "Aucun arc ne convient à ces valeurs.",
    radiusCompensation: (d) => `${d.side} est lu, mais la trajectoire n’est pas corrigée.`,
    compensationUndefined: (d) =>
      `${d.side} avec l’orientation TO ${d.orientation} : le sens de la correction n’est pas défini. Utiliser un outil dont la pointe ` +
      "est orientée vers un angle, ou programmer la trajectoire avec R0.",
    sideChanged: () => "Entre RL et RR, la commande demande une séquence avec R0.",
    approachWithoutContour: (d) => `${d.form} demande un élément de contour voisin.`,
    lengthDelta: (d) =>
      `DZL et DXL de l’outil ${d.tool} : la commande les ajoute aux longueurs d’outil. La pointe reste sur la trajectoire ; ni ` +
      "trajectoire ni brut ne changent.",
    toolRadiusUnknown: (d, w) =>
      `Le rayon de l’outil ${w.text(d.tool)} n’est pas connu : la trajectoire est calculée avec le rayon 0.`,
    wordsRecalled: (d, w) =>
      `${w.text(d.what)} : ses mots sont cités de mémoire, sans contrôle sur une page imprimée. À vérifier sur la commande.`,
    programEndMissing: () => "Il manque M30 ou M2 à la fin du programme principal.",
    tooManyBlocks: (d) =>
      `Plus de ${d.limit} séquences exécutées : arrêt à cet endroit. S’il en a moins, un saut ou une répétition ne se termine pas.`,
    tooManyMoves: (d) => `Plus de ${d.limit} déplacements : arrêt à cet endroit.`,
    contourTooLong: (d) => `Le contour compte plus de ${d.limit} séquences : arrêt à cet endroit.`,
    tooManyOperations: (d) => `Plus de ${d.limit} appels de cycle : arrêt à cet endroit.`,
    moreAlike: (d, w) =>
      `À partir d’ici, ${w.number(d.count)} autres constats du même genre (${d.code}) sont comptés, sans être listés.`,
    callsTooDeep: (d) => `Les labels s’appellent sur plus de ${d.limit} niveaux.`,
    programsTooDeep: (d) =>
      `Des programmes s’appellent sur plus de ${d.limit} niveaux : l’un d’eux s’appelle sans fin. Arrêt à cet endroit.`,
    endInCalled: (d) =>
      `${d.word} se trouve dans un programme appelé, où la commande ne le permet pas : le programme appelant continue après l’appel.`,
    programNotOpened: (d, w) => `${w.text(d.file)} n’est pas ouvert : ouvert avec ce programme, il est exécuté aussi.`,
    programNotSelected: () => "CALL SELECTED PGM demande un programme que SEL PGM a nommé avant.",
  },
} satisfies MessagesTexts;
