import type { CellName } from "../tools/tool-columns.ts";

/** What a column of a sheet is: a cell of the tool, or a code that fills several. */
export type SheetCell = Exclude<CellName, "axis" | "head"> | "CODE";

/**
 * Titles by which shops name the columns, in six languages, without accents and in small letters. The longest title
 * that is found decides. A title that means different things in different shops, such as "angle", is in none.
 */
const TITLES: readonly (readonly [SheetCell, string])[] = [
  [
    "T",
    "t; nr; no; num; number; nummer; tool; tool no; tool number; werkzeug; werkzeugnummer; werkzeug nr; wkz; wkz nr; t nr; platz; outil; n outil; numero; numero outil; numero d outil; utensile; n utensile; herramienta; n herramienta; 刀号; 刀具号; 编号; 序号",
  ],
  [
    "NAME",
    "name; bezeichnung; benennung; beschreibung; werkzeugname; description; designation; tool name; nom; nom d outil; libelle; denominazione; descrizione; nome; nombre; descripcion; denominacion; 名称; 刀具名称; 描述",
  ],
  [
    "TYPE",
    "typ; type; art; kind; werkzeugtyp; werkzeugart; tool type; type d outil; tipo; tipo utensile; tipo de herramienta; 类型; 刀具类型",
  ],
  [
    "CODE",
    "code; iso; iso code; iso bezeichnung; platte; wendeplatte; schneidplatte; wsp; insert; insert code; holder; halter; plaquette; code plaquette; inserto; plaquita; 刀片; 刀片型号",
  ],
  [
    "TO",
    "to; orientierung; werkzeugorientierung; schneidenlage; spitzenlage; lage; quadrant; orientation; tool orientation; tip orientation; tip position; orientation de l outil; position de bec; orientamento; orientacion; 刀尖方向; 方向; 刀尖方位",
  ],
  [
    "RS",
    "rs; radius; eckenradius; schneidenradius; spitzenradius; nose radius; corner radius; tip radius; re; rayon; rayon de bec; raggio; raggio di punta; raggio inserto; radio; radio de punta; 半径; 刀尖半径; 刀尖圆角",
  ],
  [
    "T-ANGLE",
    "t angle; einstellwinkel; setting angle; entering angle; approach angle; kapr; kappa; angle d attaque; angle de direction; angle d inclinaison; angolo di attacco; angolo di registrazione; angulo de posicion; angulo de ataque; 主偏角",
  ],
  [
    "P-ANGLE",
    "p angle; spitzenwinkel; eckenwinkel; point angle; included angle; nose angle; epsr; angle de pointe; angolo di punta; angulo de punta; 刀尖角; 顶角",
  ],
  [
    "CUTLENGTH",
    "cutlength; schneidenlange; edge length; cutting edge length; longueur d arete; longueur de coupe; lunghezza tagliente; longitud de filo; longitud de corte; 切削刃长度; 刃长",
  ],
  [
    "CUTWIDTH",
    "cutwidth; breite; schneidenbreite; stechbreite; width; cutting width; blade width; insert width; cw; largeur; largeur de coupe; largeur de gorge; larghezza; larghezza di taglio; ancho; ancho de corte; 刃宽; 切削宽度; 宽度",
  ],
  ["DRS", "drs; aufmass radius; radius wear; usure rayon"],
  ["DCW", "dcw; aufmass breite"],
  ["ZL", "zl; lange z; length z; z length; longueur z; lunghezza z; longitud z; z offset; z 长度"],
  ["XL", "xl; lange x; length x; x length; longueur x; lunghezza x; longitud x; x offset; x 长度"],
  ["DZL", "dzl; verschleiss z; wear z; usure z; usura z; desgaste z"],
  ["DXL", "dxl; verschleiss x; wear x; usure x; usura x; desgaste x"],
  ["DYL", "dyl"],
  ["ORI", "ori; spindelorientierung; spindle orientation"],
  [
    "R",
    "r; diameter; durchmesser; werkzeugdurchmesser; dia; d; dc; diametre; diametro; 直径; werkzeugradius; tool radius; rayon d outil; 刀具半径",
  ],
  ["DR", "dr"],
  ["L", "l; lange; werkzeuglange; length; tool length; longueur; lunghezza; longitud; 长度; 刀长"],
  ["DL", "dl"],
  ["LCUTS", "lcuts; nutzlange; spannutlange; flute length; lcf"],
  ["PITCH", "pitch; steigung; gewindesteigung; p; pas; pas du filetage; passo; paso; 螺距"],
  ["DAXN", "daxn; kleinster aussendurchmesser axial; axial dmin; min face groove diameter"],
  ["DAXX", "daxx; grosster aussendurchmesser axial; axial dmax; max face groove diameter"],
  [
    "CDX",
    "cdx; stechtiefe; max stechtiefe; cutting depth; max cutting depth; groove depth; tmax; profondeur de gorge; profondeur de coupe; profondita di taglio; profundidad de corte; 切深; 最大切深",
  ],
  [
    "CUTDIA",
    "cutdia; abstechdurchmesser; abstech diameter; max abstech diameter; max abstechdurchmesser; parting diameter; diametre de tronconnage; 切断直径",
  ],
  [
    "DMIN",
    "dmin; kleinste bohrung; mindestbohrung; min bore; minimum bore; min bore diameter; alesage min; alesage minimum; foro minimo; 最小孔径",
  ],
  [
    "SUPPORT",
    "support; abstutzung; unterstutzung; blade support; insert support; soutien; supporto; soporte; 支撑; 刀板支撑",
  ],
  ["PL", "pl; spitzenlange; point length; longueur de pointe"],
  ["width", "holder width; schaftbreite; shank width; largeur du corps; 刀杆宽度"],
  ["length", "holder length; schaftlange; shank length; longueur du corps; 刀杆长度"],
  ["offsetZ", "holder offsetz"],
  ["offsetX", "holder offsetx"],
];

const bare = (text: string) =>
  text
    .slice(0, 200)
    .replaceAll("ß", "ss")
    .replace(/[⌀Øø∅]/g, " diameter ")
    .normalize("NFD")
    .replace(/\p{M}/gu, "")
    .toLowerCase();

/** A title as it is compared: small letters without accents, signs and units. */
export const plainTitle = (title: string): string =>
  bare(title)
    .replace(/[[(][^[(\])]*[\])]/g, " ")
    .replace(/[^\p{L}\p{N}]+/gu, " ")
    .trim();

const KNOWN = new Map(TITLES.flatMap(([cell, names]) => names.split("; ").map((name) => [name, cell] as const)));
const LONGEST = Math.max(...[...KNOWN.keys()].map((name) => name.split(" ").length));
/** Shorter names are compared with whole titles only. */
const LEAST_LETTERS = 4;

/** What a title says about its column, and how sure: the longer the known name in it. */
export function meaningOfTitle(title: string): { readonly cell: SheetCell; readonly sure: number } | null {
  const plain = plainTitle(title);
  const whole = KNOWN.get(plain);
  if (whole) return { cell: whole, sure: 100 };
  const words = plain.split(" ");
  for (let n = Math.min(LONGEST, words.length); n > 0; n--)
    for (let i = 0; i + n <= words.length; i++) {
      const name = words.slice(i, i + n).join(" ");
      const cell = KNOWN.get(name);
      if (cell && (name.length >= LEAST_LETTERS || /\p{Script=Han}/u.test(name))) return { cell, sure: n };
    }
  return null;
}

/** Unit in a title or a value; null if there is none. */
export function unitIn(text: string): "mm" | "inch" | null {
  if (/\b(?:inch(?:es)?|zoll|pouces?|pollici|pulgadas?)\b|[[(]\s*(?:in|")\s*[\])]|\d\s*(?:in\b|")|英寸/i.test(text))
    return "inch";
  return /(?:\b|\d)mm\b|毫米/i.test(text) ? "mm" : null;
}

/** Whether a title speaks of a diameter. */
export const saysDiameter = (title: string): boolean =>
  /\b(?:diameter|durchmesser|\w*durchmesser|dia|dc?|diametre|diametro)\b|直径/.test(
    bare(title).replace(/[^\p{L}\p{N}]+/gu, " "),
  );
