import type { MessagesTexts } from "../../message-texts.ts";
import { running } from "./messages/running.ts";
import { threads } from "./messages/threads.ts";

/** The value that a finding proposes, if any. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : ` Proposé : ${say(value)}.`;
const count = (n: number, one: string, many: string) => `${n} ${n < 2 ? one : many}`;

const reasons: MessagesTexts["reasons"] = {
  insertRadius: "rayon de bec",
  mainEdge: "arête de coupe principale",
  secondaryEdge: "arête de coupe secondaire",
  toolWidth: "largeur de l’outil",
  cutLength: "CUTLENGTH",
  limit: "limite d’usinage",
  plunging: "plongée non autorisée",
  oversize: "surépaisseur",
  smoothing: "marches entre les passes",
  correction: "correction de l’outil",
  overCrest: "matière au-dessus du sommet du filet",
  behindContour:
    "creux derrière le contour, hors d’atteinte de ce cycle ; pour la forme F, insérer « Dégagement normalisé » comme opération",
};

const ELEMENT = { angle: "angle", length: "longueur", radius: "rayon" };

/** Clamping devices. */
const CLAMPED = {
  jaws: "les mors",
  chuck: "le mandrin",
  collet: "la pince",
  driver: "l’entraîneur",
  tailstock: "la contre-poupée",
  limit: "la limite de serrage",
};

/** Units of a feed. */
const FEED = { "mm/min": "mm/min", "mm/rev": "mm/tr" };

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
      `${w.number(d.value)} n’est pas autorisé (${d.choices.join(", ")}).${nearest(d.nearest, w.number)}`,
    startEqualsEnd: (d, w) => `Départ et fin sont identiques : ${d.other} vaut aussi ${w.value(d.value)}.`,
    startLevelWithEnd: (d, w) =>
      `Le point de départ est à ${d.axis} ${w.size(d.value)}, comme la fin du contour : il n’y a rien à usiner entre les deux.`,
    diameterNegative: (d, w) =>
      `${w.value(d.value)} est un diamètre au-delà de l’axe de rotation.${nearest(d.nearest, w.value)}`,
    elementTooLong: (d, w) => `${w.size(d.size)} est trop long pour l’élément : max. ${w.size(d.max)}.`,
    cornersTooWide: (d, w) =>
      `Deux rayons de coin de ${w.size(d.radius)} dépassent la largeur du fond : max. ${w.size(d.max)}.` + ``,
    wallsMeet: (d, w) =>
      `Avec ${w.angle(d.angle)}, les flancs se rejoignent au-dessus du fond : indiquer moins de ${w.angle(d.max)}.`,
    cornerSmallerThanInsert: (d, w) =>
      `Le rayon de coin ${w.size(d.radius)} est inférieur au rayon de bec ${w.size(d.insert)} : le coin garde ${w.size(d.insert)}.`,
    recessNarrowerThanTool: (d, w) =>
      `Le fond de la gorge est large de ${w.size(d.width)}, l’outil et la surépaisseur exigent ${w.size(d.tool)}.${nearest(d.nearest, w.value)}`,
    angleNotFollowed: (d, w) =>
      `${d.element === undefined ? "L’" : `Élément ${d.element} : l’`}outil ne peut pas suivre ${w.angle(d.angle)} : ` +
      (d.edge === "behindContour"
        ? "l’angle mène derrière le contour, hors d’atteinte de ce cycle avec tout outil"
        : `${d.edge === "toolWidth" ? "la " : "l’"}${reasons[d.edge]} permet ${w.angle(d.max)}`) +
      " ; il reste de la matière résiduelle.",
    tooManyPasses: (d, w) => `${d.passes} passes dépassent le maximum de ${d.most}.${nearest(d.nearest, w.size)}`,
    infeedOverCutLength: (d, w) =>
      `La passe ${w.size(d.infeed)} dépasse CUTLENGTH ${w.size(d.cutLength)} : réduite à ${w.size(d.cutLength)}.`,
    depthOverCutLength: (d, w) =>
      `La profondeur ${w.size(d.depth)} dépasse CUTLENGTH ${w.size(d.cutLength)} : il reste de la matière résiduelle.`,
    offsetReduced: (d, w) =>
      `Le décalage ${w.size(d.offset)} est réduit à ${w.size(d.kept)} : ` +
      `${count(d.passes, "passe se partage", "passes se partagent")} 80 % de la largeur effective.`,
    offsetOverLimit: (d, w) =>
      `Le décalage latéral de ${count(d.passes, "passe", "passes")} atteint ${w.size(d.offset)} ; 80 % de la ` +
      `largeur effective font ${w.size(d.max)}.${nearest(d.nearest, w.size)}`,
    toolUnfit: (d) =>
      `Un outil ${d.type} d’orientation ${d.orientation} ne convient pas ici. Utiliser ${d.types.join(" ou ")} avec ` +
      `l’orientation ${d.orientations.join(", ")}.`,
    toolCannotCutSideways: (d) =>
      `Un outil ${d.type} ne peut que plonger, or ce cycle usine aussi latéralement. Utiliser un outil RECTURN.`,
    flanksNotChecked: () => "T-ANGLE ou P-ANGLE est vide : les flancs de la plaquette ne sont pas contrôlés.",
    toolColumn: (d, w) => {
      const what =
        d.value === null
          ? d.column === "TYPE"
            ? "TYPE manque ou n’est pas un type d’outil."
            : `${d.column} manque ou n’est pas un nombre.`
          : `${d.column} ${w.value(d.value)} n’est pas possible.`;
      if (d.min !== undefined && d.max !== undefined)
        return `${what} Autorisé : ${w.value(d.min)} à ${w.value(d.max)}.`;
      if (d.min !== undefined)
        return `${what} La valeur doit être ${d.column === "CUTWIDTH" ? "supérieure à" : "au moins"} ${w.value(d.min)}.`;
      return d.max === undefined ? what : `${what} La valeur doit être inférieure à ${w.value(d.max)}.`;
    },
    toolNumberTwice: (d) => `L’outil ${d.number} est déjà dans le tableau.${nearest(d.nearest, String)}`,
    toolName: (d, w) =>
      `« ${w.text(d.text)} » : un nom a au plus ${d.max} caractères, en majuscules, chiffres et # $ % & , - . _ seulement.`,
    holderAxis: (d, w) => `« ${w.text(d.text)} » : le corps doit être suivant X ou suivant Z.`,
    holderHead: (d, w) =>
      `« ${w.text(d.text)} » n’est pas un contour. Indiquer chaque coin sous la forme Z/X depuis la pointe, avec un espace entre les coins et un point-virgule entre les parties ; une partie a au moins trois coins.`,
    bladeSupport: (d, w) => `« ${w.text(d.text)} » n’est pas un support de lame : NONE, STRAIGHT ou CURVED.`,
    straightBlade: () =>
      "Une lame droite frotte dans une gorge axiale : il faut une lame courbe adaptée au ⌀ (DAXN, DAXX).",
    pointDiffers: (d, w) =>
      `La longueur de pointe ${w.size(d.length)} ne correspond pas à ${w.angle(d.angle)}, qui donne ${w.size(d.byAngle)} : l’angle est retenu.`,
    betterTool: (d) => `L’outil ${d.tool} ${d.name} convient à ce contour.`,
    startInArea: (d, w) =>
      `Le point de départ ${w.place(d.x, d.z)} est dans la zone à usiner : l’outil va d’abord à la distance d’approche.`,
    startInMaterial: (d, w) => `Le point de départ ${w.place(d.x, d.z)} est dans la matière.`,
    startBelowContour: (d, w) =>
      `Le point de départ est ${w.length(d.below)} sous le départ du contour : l’outil va d’abord au départ du contour.`,
    startBehindContour: (d, w) =>
      `Le point de départ est ${w.length(d.behind)} derrière le départ du contour : l’outil va d’abord en Z à la distance d’approche de ${w.size(
        d.clearance,
      )} devant.`,
    startInPart: (d, w) =>
      `Le point de départ est dans la pièce finie : rien n’est usiné de là. Point de départ valide : ${w.place(d.x, d.z)}.`,
    insertAcrossAxis: (d, w) =>
      `La plaquette dépasse l’axe de ${w.length(d.reach)} et y endommage le contour.` +
      (d.nearest === undefined
        ? " La plaquette est trop longue pour cet alésage."
        : ` Dégagée avec un point de départ à partir de X${w.diameter(d.nearest)}.`),
    boreMissing: (d, w) =>
      `Pas d’alésage : la matière est pleine à partir de Z${w.signed(d.z)}, le cycle usine jusqu’à Z${w.signed(
        d.to,
      )}. Percer d’abord jusque-là à ${w.diameter(d.need)} au moins.`,
    startOnWrongSide: (d, w) =>
      `Le contour se dirige vers le point de départ : rien n’est usiné de ce côté. Point de départ valide : ${w.place(d.x, d.z)}.`,
    startInsideEnvelope: (d, w) =>
      `Le point de départ est plus près du contour que la distance ${w.size(d.clearance)} : l’outil va directement au contour à l’avance de finition.`,
    limitOnWrongSide: (d, w) =>
      `Avec la limite ${w.value(d.limit)}, rien n’est usiné du côté de l’outil.${nearest(d.nearest, w.value)}`,
    cutBehindLimit: (d, w) =>
      `Au-delà de la limite, ${w.area(d.area)} de matière sont usinés en ${w.place(
        d.x,
        d.z,
      )} : la limite s’applique au contour, pas à l’approche ni à la sortie.` +
      (d.finishing
        ? " L’ébauche seule (Q215 = 1) n’y usine pas."
        : " Placer la limite de sorte que l’approche et la sortie ne rencontrent pas de matière."),
    nothingToCut: () => "Entre le point de départ et le contour, il n’y a rien à usiner.",
    contourMissing: (d, w) =>
      d.label === "" ? "Le contour manque." : `Le contour LBL ${w.text(d.label)} n’existe pas.`,
    contourTooShort: () => "Un contour exige au moins deux points différents.",
    contourFlat: (d) => `Début et fin du contour ont le même ${d.axis} : il n’y a rien à usiner entre eux.`,
    contourEndCovered: (d, w) =>
      `Le contour finit en ${w.place(
        d.x,
        d.z,
      )} à l’intérieur de lui-même : un élément dépasse cette fin, la pièce ne peut pas continuer.`,
    contourPoint: (d) => `Élément ${d.element} : le point final manque ou est inaccessible.`,
    cornerElementAlone: (d) =>
      `Élément ${d.element} : un chanfrein ou un arrondi exige un élément avant et après, un chanfrein deux droites.`,
    cornerElementTooLong: (d, w) =>
      `Élément ${d.element} : ${w.size(d.size)} ne tient pas entre les éléments voisins : max. ${w.size(d.max)}.`,
    arcOffCircle: (d, w) => `Élément ${d.element} : le point final s’écarte du cercle de ${w.size(d.gap)}.`,
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
      `Élément ${d.element} : avec cette longueur, ce rayon ou cet angle, l’élément voisin est inaccessible.`,
    centreMissing: (d) => `Élément ${d.element} : le centre du cercle manque ; programmer CC avant l’élément.`,
    contourCrossesItself: (d) => `L’élément ${d.element} croise l’élément ${d.other}.`,
    toolRadiusTooLarge: (d, w) =>
      `Élément ${d.element} : un rayon d’outil de ${w.size(d.radius)} ne passe pas.${nearest(d.nearest, w.size)}`,
    pathCutsContour: (d, w) =>
      `Le long de l’élément ${d.element}, l’outil endommage l’élément ${d.other} de ${w.length(d.depth)} en ${w.spot(
        d.x,
        d.y,
        undefined,
      )} : l’outil est trop grand ; la commande ne contrôle que les éléments voisins.${nearest(d.nearest, w.size)}`,
    approachNeedsSide: () => "CT exige RL ou RR : avec R0, la commande s’arrête ici.",
    approachSideAssumed: () => "R0 ne définit pas le côté : l’approche est supposée à gauche du contour. Non vérifié.",
    approachInsideCircle: (d, w) =>
      `${d.point} est à l’intérieur du cercle de R ${w.size(d.radius)} : aucune tangente n’est possible depuis ce point.${nearest(d.nearest, w.size)}`,
    approachCutsContour: (d, w) =>
      `Entre ${d.point} et le contour, l’outil endommage le contour de ${w.length(d.depth)} en ${w.spot(d.x, d.y, d.z)} ; la commande ne le contrôle pas. ${d.point} libre : ${w.spot(d.freeX, d.freeY, d.freeZ)}.`,
    approachValueCutsContour: (d, w) =>
      `Entre ${d.point} et le contour, l’outil endommage le contour de ${w.length(d.depth)} en ${w.spot(d.x, d.y, d.z)} ; la commande ne le contrôle pas. Libre avec ${d.word} ${w.size(d.nearest)}.`,
    approachBlocked: (d, w) =>
      `Entre ${d.point} et le contour, l’outil endommage le contour de ${w.length(d.depth)} en ${w.spot(d.x, d.y, d.z)} ; la commande ne le contrôle pas.`,
    undercutNeighbours: (d) =>
      `Élément ${d.element} : un dégagement exige un cylindre parallèle à l’axe et une face perpendiculaire, une gorge un ` +
      "élément droit de sa direction.",
    recessWord: (d) => `Élément ${d.element} : ${d.word} manque ou ne donne aucune forme valide.`,
    recessWordsExclusive: (d) => `Élément ${d.element} : ${d.other} et ${d.word} s’excluent. N’en indiquer qu’un.`,
    pitchNotListed: (d, w) => {
      const near = [d.below, d.above].flatMap((n) => (n === undefined ? [] : [w.size(n, 4)])).join(" et ");
      return `Élément ${d.element} : DIN 76 n’a pas de dégagement pour le pas ${w.size(
        d.pitch,
        4,
      )} ; pas les plus proches : ${near}. En utiliser un ou indiquer ${d.words}.`;
    },
    undercutDefaults: (d) =>
      `Élément ${d.element} : ${d.words} repris de la norme, non vérifié pour cette commande ; à programmer par sécurité.`,
    materialLeft: (d, w) =>
      d.asked === undefined
        ? `Matière résiduelle en ${w.place(d.x, d.z)} : ${w.area(d.area)}. Cause : ${reasons[d.reason]}.`
        : d.reason === "oversize"
          ? `Surépaisseur en ${w.place(d.x, d.z)} : ${w.area(d.area)}, comme programmé.`
          : `Le coin en ${w.place(d.x, d.z)} a le rayon de bec : ${w.area(d.area)} de matière résiduelle. Aucun autre rayon n’est programmé.`,
    gouge: (d, w) => `Violation de contour en ${w.place(d.x, d.z)} : ${w.area(d.area)}.`,
    rapidInStock: (d, w) => `Avance rapide à travers ${w.area(d.area)} de matière en ${w.place(d.x, d.z)}.`,
    holderContact: (d, w) => `Le porte-outil touche la matière en ${w.place(d.x, d.z)}.`,
    cutBelowContour: (d, w) =>
      `Cette passe est de ${w.area(d.area)} sous le contour du cycle de la séquence ${d.block}, en ${w.place(
        d.x,
        d.z,
      )}. La confirmer si elle est voulue.`,
    intendedCut: (d, w) =>
      `${d.blocks.length === 1 ? "Passe sous le contour déclarée voulue, séquence" : "Passes sous le contour déclarées voulues, séquences"} ${d.blocks.join(
        ", ",
      )} : ${w.area(d.area)} en ${w.place(d.x, d.z)}.`,
    cameLoose: (d, w) =>
      `${{ piece: "Un morceau", ring: "Un anneau", slug: "Une débouchure" }[d.shape]} de ${w.area(d.area)} en ${w.place(
        d.x,
        d.z,
      )} n’est plus relié à l’extrémité serrée : détaché par la séquence ${d.block}.`,
    partedOff: (d, w) =>
      `La pièce en ${w.place(d.x, d.z)}, ${w.area(d.area)}, est tronçonnée à la séquence ${d.block} et retirée de la simulation.`,
    cutOnLoosePiece: (d, w) =>
      `La séquence ${d.block} détache ce morceau avant la fin de son usinage : en ${w.place(d.x, d.z)}, ${w.area(
        d.area,
      )} seraient usinés sur un morceau qui n’est plus serré. Détachez-le en dernier.`,
    behindBlank: (d, w) =>
      d.motion === "unheld"
        ? `L’extérieur est tourné jusqu’à l’extrémité arrière de la pièce brute en Z${w.size(
            d.rear,
          )} : il ne reste pas de surface de serrage. Indiquer le serrage si la pièce est tenue autrement.`
        : `${d.motion === "rapid" ? "Avance rapide" : "Usinage"} derrière l’extrémité arrière de la pièce brute en Z${w.size(
            d.rear,
          )}, en ${w.place(d.x, d.z)} : le moyen de serrage s’y trouve.`,
    clampContact: (d, w) =>
      `${d.by === "tool" ? "L’outil" : "Le porte-outil"} entre en collision avec ${CLAMPED[d.part]} en ${w.place(
        d.x,
        d.z,
      )}. Terminer la passe plus tôt ou modifier le serrage.`,
    contactsUnlooked: (d) =>
      `${d.limit} déplacements endommagent le contour, entrent en avance rapide dans la matière ou la touchent avec le porte-outil : plus de contrôle à partir d’ici.`,
    deeperThanInfeed: (d, w) =>
      "" +
      (d.pass === undefined ? "Une passe de lissage ou de finition" : `La passe ${w.number(d.pass)}`) +
      ` a ${w.length(d.depth)} de profondeur ; max. ${w.length(d.allowed)} autorisés.`,
    blankLacks: (d, w) =>
      `${w.text(d.what)} omet ${w.area(d.area)} de la matière présente d’après le programme. Ce contour s’applique.`,
    blankGone: (d, w) =>
      `${w.text(d.what)} décrit ${w.area(d.area)} de matière déjà enlevée. La matière enlevée n’est pas restituée.`,
    nothingCut: () => "Cette opération n’enlève pas de matière.",
    airPasses: (d) => (d.count === 1 ? "1 passe à vide." : `${d.count} passes à vide.`),

    notUnderstood: (d, w) => `« ${w.text(d.text)} » n’est pas reconnu : conservé, non simulé.`,
    wordNotUnderstood: (d, w) => `Le mot « ${w.text(d.text)} » n’est pas reconnu.`,
    wordTwice: (d, w) => `${w.text(d.word)} est programmé deux fois dans cette séquence ; le dernier s’applique.`,
    equalsMissing: (d, w) => `« ${w.text(d.text)} » n’a pas de signe égal ; la lecture le suppose présent.`,
    blankBeforeEquals: (d, w) => `« ${w.text(d.text)} » a un espace avant le signe égal.`,
    lineTooLong: (d) => `La ligne a plus de ${d.most} caractères : elle reste dans le texte, mais n’est pas lue.`,
    badNumber: (d, w) => `« ${w.text(d.text)} » n’est pas un nombre.`,
    wordMissing: (d, w) => `${w.text(d.word)} manque dans cette séquence.`,
    blockNumber: (d) => `Numéro de séquence ${d.found} hors suite ; attendu : ${d.expected}.`,
    blockNumberMissing: (d) => `La séquence n’a pas de numéro ; attendu : ${d.expected}.`,
    listWithoutTilde: (d) =>
      `${d.places === 1 ? "Il manque le ~ en fin de ligne dans une liste" : `Il manque le ~ en fin de ligne dans ${d.places} listes`} ` +
      "de cycle : la commande ne peut pas charger le programme.",
    continuationOpen: () => "La ligne finit par ~, mais la suite manque.",
    isoProgram: () => "Le texte est en DIN/ISO. L’ouvrir comme programme séparé pour le convertir en Klartext.",
    frameMissing: (d) => `Il manque ${d.which} au programme.`,

    notSimulated: (d, w) => `${w.text(d.what)} : conservé, non simulé.`,
    notProved: (d, w) =>
      `${w.text(d.what)} n’est pas simulé et peut modifier la trajectoire ou la pièce brute : non vérifié à partir d’ici.`,
    cycleNotSimulated: (d, w) => `Cycle ${d.cycle} ${w.text(d.name)} : conservé, non simulé.`,
    noCycleDefined: () => "Aucun cycle n’est défini avant l’appel.",
    noToolCalled: () => "Aucun outil n’est appelé avant cette séquence.",
    toolUnknown: (d, w) => `L’outil ${w.text(d.tool)} n’est pas dans le tableau.`,
    notInTurnMode: () => "Le cycle ne s’exécute qu’en FUNCTION MODE TURN : programmer cette séquence avant l’appel.",
    compensationActive: (d) =>
      `${d.side} est actif ici, or la commande exige R0 : programmer R0 dans la séquence de positionnement précédente.`,
    feedZero: (d, w) =>
      `${w.text(d.word)} : l’avance de coupe est de 0 ici. Indiquer une avance supérieure à 0 ; FAUTO reprend le F de TOOL CALL.`,
    feedUnlikely: (d, w) =>
      `Une avance de ${w.feed(d.feed, FEED[d.unit])} est peu vraisemblable. Vérifier M136 : avec M136, F est par tour.`,
    pointBeyondDepth: (d, w) =>
      `Le trou a ${w.size(d.depth)} de profondeur, la pointe du foret ${w.size(d.point)} : le trou n’atteint pas son diamètre.`,
    drillTooShort: (d, w) =>
      `Le trou a ${w.size(d.depth)} de profondeur, les arêtes du foret (LCUTS) ${w.size(d.edges)} : la queue peut frotter.`,
    centreMouth: (d, w) =>
      `Le trou de centre a ⌀${w.size(d.mouth)} à la face au lieu de ⌀${w.size(d.wanted)} : son foret demande une profondeur de ${w.size(d.depth)}.`,
    pitchOfTap: (d, w) => `Q239 vaut ${w.size(d.pitch)}, mais le taraud du tableau a un PITCH de ${w.size(d.tap)}.`,
    freeChosen: () =>
      "À partir d’ici, plusieurs contours correspondent aux données : le plus court est représenté. La commande " +
      "utilise celui choisi avec FSELECT.",
    freeUnsolved: (d, w) =>
      `${w.text(d.form)} : les données ne déterminent pas cet élément ou se contredisent. Indiquer d’autres valeurs, ou FSELECT.`,
    cycleNeverCalled: (d) => `Le cycle ${d.cycle} est défini mais jamais appelé : CYCL CALL ou M99 manque.`,
    neverReached: (d) =>
      `Le programme se termine avec ${d.by}, avant cette séquence : la séquence n’est jamais exécutée.`,
    listOfOlderSoftware: (d, w) =>
      `La liste de paramètres du cycle ${d.cycle} vient d’un logiciel plus ancien. La commande ajoute : ${d.filled
        .map((word) => w.text(word))
        .join(", ")}.`,
    parameterForeign: (d, w) =>
      `${w.text(d.name)} n’est pas autorisé ici : le cycle ${d.cycle} n’a pas ce paramètre, ou le paramètre est programmé deux fois.`,
    runsIntoLabel: (d, w) => `Le programme entre dans le contour de LBL ${w.text(d.label)} : il manque M30 avant.`,
    contourStartIncomplete: (d) => `La première séquence du contour a besoin de X et de Z ; il manque ${d.axis}.`,
    approachUncompensated: (d) =>
      `${d.form} n’a ni RL ni RR : le contour qui suit est exécuté sans correction de rayon.`,
    labelMissing: (d, w) => `LBL ${w.text(d.label)} n’existe pas.`,
    labelTwice: (d, w) => `LBL ${w.text(d.label)} est programmé deux fois.`,
    labelNotClosed: (d, w) => `LBL ${w.text(d.label)} n’est pas fermé par LBL 0.`,
    contourNotNamed: (d) => `Le cycle ${d.cycle} exige, avant l’appel, le cycle 14 avec le contour.`,
    contoursJoined: (d, w) =>
      `${w.text(d.joined)} : plusieurs contours sont combinés ici. Le cycle ${w.number(d.cycle)} n’usine qu’un contour ; la trajectoire n’est pas représentée.`,
    errorRaised: (d, w) =>
      d.error === null
        ? "FN 14 : la commande s’arrête ici avec une erreur ; les séquences suivantes ne sont pas exécutées."
        : `FN 14 : la commande s’arrête ici avec l’erreur ${w.number(d.error)} ; les séquences suivantes ne sont pas exécutées.`,
    contourInFile: (d, w) =>
      `Le contour est dans le fichier ${w.text(d.file)}, absent ici : placer le contour dans un label et le sélectionner avec le cycle 14.`,
    feedMissing: () => "Aucune avance n’est programmée.",
    spindleMissing: () => "Aucune vitesse de broche n’est programmée ; les temps manquent.",
    parameterUnset: (d) => `${d.name} n’a pas de valeur ici.`,
    divisionByZero: () => "Division par zéro.",
    notFinite: (d, w) => `« ${w.text(d.text)} » ne donne pas de nombre utilisable.`,
    clampingUnread: (d, w) => `CLAMPING : « ${w.text(d.what)} » n’est pas reconnu et est ignoré.`,
    clampingIncomplete: (d) => `CLAMPING est ignoré : ${d.words} manque ou n’est pas valide. Le serrage est inconnu.`,
    clampingTwice: () => "CLAMPING est défini deux fois : le premier s’applique. Effacer celui-ci.",
    clampingMisses: (d, w) =>
      `Le serrage ne tient pas la pièce brute : aucune surface de ${w.diameter(
        d.diameter,
      )} dans la zone de serrage. Vérifier ⌀, longueur et face de CLAMPING.`,
    blankMissing: () => "Le programme ne définit pas de pièce brute.",
    blankNotTurned: (d, w) => `Une pièce brute de type ${w.text(d.form)} n’est pas un corps de révolution.`,
    endsExchanged: (d, w) =>
      d.axis === "X"
        ? `De X${w.diameter(d.start)} à X${w.diameter(d.end)}, il n’y a pas de matière à usiner. Départ et fin (${d.other}) intervertis ?`
        : `De Z${w.signed(d.start)} à Z${w.signed(d.end)}, le cycle usine en s’éloignant du mandrin. Départ et fin (${d.other}) intervertis ?`,
    endInFront: (d, w) => `Z${w.signed(d.value)} est devant la pièce. ${w.signed(d.nearest)} ?`,
    startInFront: (d, w) => `Z${w.signed(d.value)} est devant la pièce. ${w.signed(d.nearest)} ?`,
    diameterInSolid: (d, w) =>
      `${w.diameter(d.value)} est à l’intérieur de la pièce brute pleine : l’outil n’a pas d’alésage où commencer.`,
    diameterOutside: (d, w) => `${w.diameter(d.value)} dépasse la pièce brute, ${w.diameter(d.blank)}.`,
    blankAgainstContour: (d, w) =>
      ({
        outside: `Le contour va jusqu’à ${w.diameter(d.contour)}, la pièce brute seulement jusqu’à ${w.diameter(d.blank)}. Proposé : ${w.diameter(
          d.nearest,
        )}.`,
        bore: `L’alésage de la pièce brute est de ${w.diameter(d.blank)}, le contour finit à ${w.diameter(d.contour)} : rien n’est usiné. Proposé : ${w.diameter(
          d.nearest,
        )}.`,
        length: `Le contour va jusqu’à Z${w.signed(d.contour)}, la pièce brute seulement jusqu’à Z${w.signed(d.blank)}. Proposé : ${w.size(
          d.nearest,
        )}.`,
        allowance: `Le contour commence à Z${w.signed(d.contour)}, la pièce brute à Z${w.signed(d.blank)} : passes à vide. Proposé : ${w.signed(
          d.nearest,
        )}.`,
        thread: `Le filet a ${w.diameter(d.contour)}, la pièce brute ${w.diameter(d.blank)}. Proposé : ${w.diameter(d.nearest)}.`,
      })[d.place],
    blankImpossible: () => "La pièce brute n’a pas de volume : vérifier les cotes.",
    boxTurned: (d, w) =>
      `Le parallélépipède est traité comme le cylindre autour de ses coins, diamètre ${w.size(d.outer)}. La matière n’est sûre tout autour ` +
      `que jusqu’au diamètre ${w.size(d.inner)}. Pour une barre ronde, utiliser BLK FORM CYLINDER.`,
    blankTaken: (d, w) => `${w.text(d.what)} sert de pièce brute.`,
    blankAdds: (d, w) => `${w.text(d.what)} décrit ${w.area(d.area)} de plus que BLK FORM. Ce contour s’applique.`,
    blankTraced: () =>
      "Avec l’actualisation de la pièce brute, l’ébauche omet les niveaux sans matière. Les autres trajets à " +
      "vide, que la commande peut raccourcir, sont représentés en entier.",
    poleMissing: () => "La séquence exige un pôle CC avant elle.",
    startUnknown: () => "La position avant cette séquence n’est pas connue.",
    arcImpossible: () => "Aucun arc ne convient à ces valeurs.",
    radiusCompensation: (d) => `${d.side} est reconnu, mais la trajectoire n’est pas corrigée.`,
    compensationUndefined: (d) =>
      `${d.side} avec l’orientation TO ${d.orientation} : le sens de la correction n’est pas défini. Utiliser un outil dont la pointe ` +
      "est orientée vers un angle, ou programmer la trajectoire avec R0.",
    sideChanged: () => "Entre RL et RR, la commande exige une séquence avec R0.",
    approachWithoutContour: (d) => `${d.form} exige un élément de contour voisin.`,
    lengthDelta: (d) =>
      `DZL et DXL de l’outil ${d.tool} : la commande les ajoute aux longueurs d’outil. La pointe reste sur la trajectoire ; la trajectoire et la pièce brute ne changent pas.`,
    toolRadiusUnknown: (d, w) =>
      `Le rayon de l’outil ${w.text(d.tool)} n’est pas connu : la trajectoire est calculée avec le rayon 0.`,
    wordsRecalled: (d, w) => `${w.text(d.what)} : paramètres non vérifiés dans un manuel ; à vérifier sur la commande.`,
    programEndMissing: () => "Il manque M30 ou M2 à la fin du programme principal.",
    tooManyBlocks: (d) => `Plus de ${d.limit} séquences exécutées : arrêt à cet endroit.`,
    tooManyRepeated: (d) =>
      `Plus de ${d.limit} séquences répétées : arrêt à cet endroit. Un saut ou une répétition ne se termine peut-être jamais.`,
    tooManyMoves: (d) => `Plus de ${d.limit} déplacements : arrêt à cet endroit.`,
    contourTooLong: (d) => `Le contour compte plus de ${d.limit} séquences : arrêt à cet endroit.`,
    tooManyOperations: (d) => `Plus de ${d.limit} appels de cycle : arrêt à cet endroit.`,
    moreAlike: (d, w) =>
      `À partir d’ici, ${w.number(d.count)} autres messages du même type (${d.code}) sont comptés, mais pas listés.`,
    callsTooDeep: (d) => `Appels de labels imbriqués sur plus de ${d.limit} niveaux.`,
    programsTooDeep: (d) =>
      `Appels de programmes imbriqués sur plus de ${d.limit} niveaux : un programme s’appelle sans fin. Arrêt à cet endroit.`,
    endInCalled: (d) =>
      `${d.word} n’est pas autorisé dans un programme appelé : le programme appelant continue après l’appel.`,
    programNotOpened: (d, w) => `${w.text(d.file)} n’est pas ouvert : l’ouvrir avec ce programme pour l’exécuter.`,
    programNotSelected: () => "CALL SELECTED PGM exige un programme sélectionné avant avec SEL PGM.",
  },
} satisfies MessagesTexts;
