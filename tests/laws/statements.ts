import * as fc from "fast-check";
import type { Statement } from "../../src/nc/statement.ts";
import type { AxisName, Formula, TextFormula, Value, Words } from "../../src/nc/words.ts";

/* Statements of every kind, with values that a control can store. */

const number = fc
  .tuple(fc.integer({ min: -99999999, max: 99999999 }), fc.constantFrom(1, 10, 100, 1000, 10000))
  .map(([n, s]) => (n === 0 ? 0 : n / s));
const value: fc.Arbitrary<Value> = fc.oneof(
  number,
  fc.record({
    parameter: fc.tuple(fc.constantFrom("Q", "QL", "QR"), fc.nat(1999)).map(([q, n]) => q + String(n)),
    negative: fc.boolean(),
  }),
);
const axisName = fc.constantFrom<AxisName[]>("X", "Y", "Z", "A", "B", "C", "U", "V", "W");
const axes = fc.uniqueArray(fc.record({ axis: axisName, value, incremental: fc.boolean() }), {
  selector: (w) => w.axis,
  maxLength: 4,
});
const optional = <T, K extends string>(key: K, of: fc.Arbitrary<T>) =>
  fc.option(of).map((v) => (v === null ? {} : { [key]: v }) as { [P in K]?: T });
const feed = fc.oneof(
  fc.constantFrom("max" as const, "auto" as const),
  fc.record({ value, unit: fc.constantFrom("F" as const, "FU" as const, "FZ" as const) }),
);
const functions = fc.array(fc.integer({ min: 0, max: 999 }), { maxLength: 4 });
const tail = fc.tuple(
  optional("compensation", fc.constantFrom("R0", "RL", "RR")),
  optional("feed", feed),
  functions.map((f) => ({ functions: f })),
);
const words = (...parts: fc.Arbitrary<object>[]): fc.Arbitrary<Words> =>
  fc.tuple(tail, ...parts).map(([common, ...own]) => Object.assign({ axes: [] }, ...common, ...own) as Words);
const withAxes = axes.map((a) => ({ axes: a }));
const polar = fc.record({ value, incremental: fc.boolean() });
const turn = fc.constantFrom("cw" as const, "ccw" as const);
const label = fc.oneof(fc.integer({ min: 0, max: 65535 }), fc.stringMatching(/^[A-Z_ ]{1,12}$/));
const name = fc.stringMatching(/^[A-Z][A-Z0-9_]{0,15}$/);
const maybe = <T>(of: fc.Arbitrary<T>) => fc.option(of);
const textParameter = fc.nat(1999).map((n) => `QS${n}`);
const quoted = fc.stringMatching(/^[A-Za-z0-9 .\\:;_-]{0,12}$/);
const textSource: fc.Arbitrary<TextFormula> = fc.oneof(
  quoted.map((text) => ({ kind: "quoted" as const, text })),
  textParameter.map((parameter) => ({ kind: "parameter" as const, parameter })),
);
const textPart: fc.Arbitrary<TextFormula> = fc.oneof(
  textSource,
  fc.record({ kind: fc.constant("toChar" as const), value, decimals: maybe(value) }),
  fc.record({ kind: fc.constant("part" as const), source: textSource, begin: maybe(value), length: maybe(value) }),
);
const text: fc.Arbitrary<TextFormula> = fc.oneof(
  textPart,
  fc.array(textPart, { minLength: 2, maxLength: 4 }).map((parts) => ({ kind: "joined" as const, parts })),
);
const ofText: fc.Arbitrary<Formula> = fc.oneof(
  fc.record({
    kind: fc.constant("ofText" as const),
    name: fc.constantFrom("TONUMB" as const, "STRLEN" as const),
    source: textSource,
    search: fc.constant(null),
    begin: fc.constant(null),
  }),
  fc.record({
    kind: fc.constant("ofText" as const),
    name: fc.constantFrom("INSTR" as const, "STRCOMP" as const),
    source: textSource,
    search: textSource,
    begin: maybe(value),
  }),
);
const NAMES = [
  "SIN",
  "COS",
  "TAN",
  "ASIN",
  "ACOS",
  "ATAN",
  "SQRT",
  "SQ",
  "LN",
  "LOG",
  "EXP",
  "NEG",
  "INT",
  "ABS",
  "FRAC",
  "SGN",
];
const formula: fc.Arbitrary<Formula> = fc.letrec<{ f: Formula }>((tie) => ({
  f: fc.oneof(
    { maxDepth: 4 },
    value.map((v): Formula => ({ kind: "value", value: v })),
    ofText,
    fc.record({
      kind: fc.constantFrom(
        "sum" as const,
        "difference" as const,
        "product" as const,
        "quotient" as const,
        "remainder" as const,
        "power" as const,
      ),
      left: tie("f"),
      right: tie("f"),
    }),
    fc.record({ kind: fc.constant("call" as const), name: fc.constantFrom(...NAMES), of: tie("f") }),
  ),
})).f;
/** The operands of each FN function. */
const one = value.map((v): Formula => ({ kind: "value", value: v }));
const two = (kind: "sum" | "difference" | "product" | "quotient" | "length" | "angle") =>
  fc.record({ kind: fc.constant(kind), left: one, right: one }) as fc.Arbitrary<Formula>;
const called = (name: string) => one.map((of): Formula => ({ kind: "call", name, of }));
const FN_FORMULAS = [
  [0, one],
  [1, two("sum")],
  [2, two("difference")],
  [3, two("product")],
  [4, two("quotient")],
  [5, called("SQRT")],
  [6, called("SIN")],
  [7, called("COS")],
  [8, two("length")],
  [13, two("angle")],
] as const;
const target = fc.constantFrom("Q1", "QL2", "QR33", "Q1999");
const fileName = fc.oneof(
  fc.constantFrom("A.H", "TNC:\\work\\part 1.h", "../SUB/B"),
  textParameter.map((parameter) => ({ parameter, negative: false })),
);
const place = fc.oneof(
  fileName.map((file) => ({ file })),
  fc.record({
    label: fc.oneof(
      label,
      value.filter((v) => typeof v === "object").map((v) => ({ ...(v as object), negative: false })),
    ),
  }),
);
const depth = maybe(value);
const contourName = fc.nat(99).map((n) => `QC${n}`);
/** Contours joined by operators, with brackets round some of them. */
const terms: fc.Arbitrary<readonly string[]> = fc.letrec<{ t: readonly string[] }>((tie) => ({
  t: fc.oneof(
    { maxDepth: 3 },
    contourName.map((n) => [n]),
    fc.tuple(tie("t"), fc.constantFrom("|", "&", "^", "\\"), tie("t")).map(([a, sign, b]) => [...a, sign, ...b]),
    tie("t").map((inner) => ["(", ...inner, ")"]),
  ),
})).t;
/** Words of free-contour elements only. */
const freeWords = fc.uniqueArray(
  fc.oneof(
    fc.record({
      name: fc.constantFrom("AN", "IAN", "CCX", "CCY", "CCZ", "ICCX", "CCPR", "CCPA", "P1X", "P3Y", "PDX", "D", "DP"),
      value,
    }),
    fc.record({ name: fc.constant("CLSD"), value: fc.constantFrom(1, -1) }),
  ),
  { selector: (w) => w.name, maxLength: 4 },
);

/** Any statement that a reader may return. */
export const statements: fc.Arbitrary<Statement> = fc.oneof<fc.Arbitrary<Statement>[]>(
  fc
    .stringMatching(/^[ -~äß中]{0,20}$/)
    .filter((t) => !/[~;]\s*$|\s$/.test(t))
    .map((text) => ({ kind: "comment", text })),
  fc.record({ kind: fc.constantFrom("begin", "end"), name, unit: fc.constantFrom("MM", "INCH") }),
  fc.record({ kind: fc.constant("path"), path: fc.constantFrom("L", "CT", "CC"), words: words(withAxes) }),
  fc.record({
    kind: fc.constant("path"),
    path: fc.constant("C"),
    words: words(
      withAxes,
      turn.map((t) => ({ turn: t })),
    ),
  }),
  fc.record({
    kind: fc.constant("path"),
    path: fc.constant("CR"),
    words: words(
      withAxes,
      value.map((r) => ({ radius: r })),
      turn.map((t) => ({ turn: t })),
    ),
  }),
  fc.record({
    kind: fc.constant("path"),
    path: fc.constantFrom("LP", "CTP"),
    words: words(
      withAxes,
      polar.map((p) => ({ polarRadius: p })),
      optional("polarAngle", polar),
    ),
  }),
  fc
    .record({ kind: fc.constant("path"), path: fc.constant("RND"), words: words(value.map((r) => ({ radius: r }))) })
    .map((s) => ({
      ...s,
      words: { ...s.words, compensation: undefined },
    }))
    .map((s) => JSON.parse(JSON.stringify(s)) as Statement),
  fc.record({ kind: fc.constant("chamfer"), length: value, words: words() }),
  fc.record({
    kind: fc.constant("approach"),
    departing: fc.boolean(),
    form: fc.constantFrom("LT", "LN", "CT", "LCT"),
    words: words(withAxes, optional("length", value), optional("radius", value), optional("centreAngle", value)),
  }),
  fc.record({
    kind: fc.constant("path"),
    path: fc.constant("L"),
    words: words(
      withAxes,
      fc.constantFrom(128, 140).map((m) => ({ functions: [m] })),
      optional("retract", fc.oneof(value, fc.constant("max" as const))),
      optional("functionFeed", feed),
    ),
  }),
  fc.record({ kind: fc.constant("label"), label }),
  fc.record({
    kind: fc.constant("jump"),
    fn: fc.constantFrom(9, 10, 11, 12, null),
    left: value,
    compare: fc.constantFrom("EQU", "NE", "GT", "LT"),
    right: value,
    label,
  }),
  fc.record({
    kind: fc.constant("jump"),
    fn: fc.constantFrom(9, null),
    left: value,
    compare: fc.constantFrom("IS DEFINED", "IS UNDEFINED"),
    right: fc.constant(null),
    label,
  }),
  fc.record({ kind: fc.constant("datum"), shift: fc.oneof(axes, fc.constant("reset" as const)) }),
  fc.record({ kind: fc.constant("datumTable"), row: fc.constantFrom("", "TABLINE5", 'TABLINE7 "TNC:\\A.D"') }),
  fc.record({
    kind: fc.constant("mirror"),
    axes: fc.oneof(fc.uniqueArray(fc.constantFrom("X", "Y", "Z"), { minLength: 1 }), fc.constant("reset" as const)),
  }),
  fc.record({ kind: fc.constant("rotation"), angle: fc.oneof(polar, fc.constant("reset" as const)) }),
  fc.record({ kind: fc.constant("scale"), factor: fc.oneof(value, fc.constant("reset" as const)) }),
  fc.record({
    kind: fc.constant("plane"),
    text: fc.constantFrom(
      "PLANE RESET STAY",
      "PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX",
      "FUNCTION RESET TCPM",
      "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS",
    ),
  }),
  fc.record({
    kind: fc.constant("call"),
    label,
    repeat: maybe(
      fc.oneof(
        fc.integer({ min: 1, max: 65534 }),
        value.filter((v) => typeof v === "object"),
      ),
    ),
  }),
  fc.record({
    kind: fc.constant("call"),
    label: textParameter.map((parameter) => ({ parameter, negative: false })),
    repeat: fc.constant(null),
  }),
  fc.record({
    kind: fc.constant("cycleCall"),
    how: fc.constantFrom("" as const, "POS" as const),
    words: words(withAxes),
  }),
  fc.record({ kind: fc.constant("stop"), words: words() }).map((s) => s as Statement),
  fc.record({
    kind: fc.constant("toolCall"),
    tool: maybe(fc.nat(32767)),
    axis: maybe(axisName),
    speed: maybe(value),
    feed: maybe(feed),
    deltaLength: maybe(value),
    deltaRadius: maybe(value),
    extra: fc.constant([]),
  }),
  fc.record({ kind: fc.constant("toolDefinition"), tool: fc.nat(9999), length: maybe(value), radius: maybe(value) }),
  fc.record({ kind: fc.constant("mode"), mode: fc.constantFrom("TURN", "MILL"), kinematics: maybe(name) }),
  fc.record({
    kind: fc.constant("spin"),
    constantSurface: fc.boolean(),
    cuttingSpeed: maybe(value),
    speed: maybe(value),
    limit: maybe(value),
    gear: maybe(value),
  }),
  fc.record({
    kind: fc.constant("turnCorrection"),
    system: fc.constantFrom("TCS", "WPL"),
    plane: fc.constant("Z/X"),
    words: fc.array(fc.record({ name: fc.constantFrom("DZL", "DXL"), value }), { maxLength: 3 }),
  }),
  fc.record({
    kind: fc.constant("turnBlank"),
    blank: fc.oneof(
      name.map((file) => ({ file })),
      label.map((l) => ({ label: l })),
      fc.constant("off" as const),
    ),
  }),
  fc.record({
    kind: fc.constant("blankCylinder"),
    axis: fc.constant("Z"),
    outside: fc.record({ measure: fc.constantFrom("D", "R"), value }),
    length: value,
    distance: maybe(value),
    inside: maybe(fc.record({ measure: fc.constantFrom("DI", "RI"), value })),
  }),
  fc.record({
    kind: fc.constant("blankRotation"),
    axis: fc.constant("Z"),
    measure: fc.constantFrom("D", "R"),
    outline: fc.oneof(
      name.map((file) => ({ file })),
      label.map((l) => ({ label: l })),
    ),
    inner: maybe(label),
  }),
  fc.record({ kind: fc.constant("blankFile"), file: name, target: maybe(name) }),
  fc.record({ kind: fc.constant("blankBox"), corner: fc.constant(1), axis: fc.constant("Z"), axes }),
  fc.record({
    kind: fc.constant("undercut"),
    form: fc.constantFrom("TYPE_E", "THREAD"),
    words: fc.array(fc.record({ name: fc.constantFrom("R", "DEPTH", "BREADTH"), value }), { maxLength: 3 }),
  }),
  fc.record({
    kind: fc.constant("groove"),
    form: fc.constantFrom("RADIAL", "AXIAL"),
    words: fc.array(fc.record({ name: fc.constantFrom("R", "DEPTH", "CENTER"), value }), { maxLength: 3 }),
  }),
  fc.record({
    kind: fc.constant("cycleLine"),
    cycle: fc.integer({ min: 1, max: 32 }),
    line: fc.nat(9),
    text: fc.stringMatching(/^([A-Z][A-Z0-9 /]{0,10}[A-Z0-9])?$/),
  }),
  fc.record({
    kind: fc.constant("cycle"),
    cycle: fc.integer({ min: 1, max: 999 }),
    name: fc.stringMatching(/^([A-Z.]{1,8} ?[A-Z.]{1,8})?$/),
    parameters: fc.array(
      fc.record({
        q: fc.integer({ min: 200, max: 599 }).map((n) => `Q${n}`),
        value: fc.oneof(value, fc.constantFrom("auto", "max")),
        label: maybe(fc.stringMatching(/^[A-Z.' ]{0,10}[A-Z.]$/)),
      }),
      { maxLength: 20 },
    ),
  }),
  fc.record({ kind: fc.constant("selectContour"), file: fileName }),
  fc.record({
    kind: fc.constant("contourDefinition"),
    areas: fc.array(
      fc.record({ role: fc.constantFrom("P", "I", "V"), number: fc.integer({ min: 1, max: 12 }), from: place, depth }),
      {
        minLength: 1,
        maxLength: 4,
      },
    ),
  }) as fc.Arbitrary<Statement>,
  fc.record({
    kind: fc.constant("declareContour"),
    contour: contourName,
    from: place,
    depth,
  }) as fc.Arbitrary<Statement>,
  fc.record({ kind: fc.constant("contourFormula"), target: contourName, terms }),
  fc.record({
    kind: fc.constant("raise"),
    error: fc.oneof(
      fc.nat(1199),
      value.filter((v) => typeof v === "object"),
    ),
  }),
  fc.record({
    kind: fc.constantFrom("callProgram", "selectProgram"),
    file: fileName,
    bare: fc.constant(false),
  }) as fc.Arbitrary<Statement>,
  fc.record({
    kind: fc.constantFrom("callProgram", "selectProgram"),
    file: fc.constantFrom("A.H", "TNC:\\W\\B.H"),
    bare: fc.constant(true),
  }),
  fc.record({ kind: fc.constant("callSelected") }),
  fc.record({
    kind: fc.constant("free"),
    form: fc.constantFrom("FL", "FLT", "FC", "FCT", "FPOL"),
    given: freeWords,
    words: words(withAxes, optional("turn", turn), optional("radius", value), optional("length", value)),
  }),
  fc.record({
    kind: fc.constant("free"),
    form: fc.constant("FSELECT"),
    given: fc.integer({ min: 0, max: 99 }).map((n) => [{ name: "FSELECT", value: n }]),
    words: fc.constant<Words>({ axes: [], functions: [] }),
  }),
  fc.record({ kind: fc.constant("assignText"), declared: fc.boolean(), target: textParameter, text }),
  fc.record({
    kind: fc.constant("assign"),
    fn: fc.constant(null),
    target,
    formula: fc.oneof(formula, fc.constant<Formula>({ kind: "undefined" })),
  }),
  ...FN_FORMULAS.map(([fn, of]) =>
    fc.record({ kind: fc.constant("assign" as const), fn: fc.constant(fn), target, formula: of }),
  ),
) as fc.Arbitrary<Statement>;
