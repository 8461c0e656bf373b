import { describe, expect, test } from "vitest";
import { withInserted } from "../../nc/edit.ts";
import { parse } from "../../nc/parse.ts";
import { print } from "../../nc/program.ts";
import { describedFrom, newParameter, OWN_SIZES, ownField, ownStatement, readOwn, type OwnEntry } from "./own-cycle.ts";
import { freeCycle, mergedLibrary, readLibrary, readLibraryFile, writeLibrary } from "./own-library.ts";
import { readText } from "../values/field.ts";

const entry = (given: Partial<OwnEntry> = {}): OwnEntry => ({
  id: "c1",
  number: "317",
  name: "BAR PULLER",
  parameters: [
    newParameter("p1", { q: "Q1711", prompt: "PULL LENGTH", kind: "length", min: "0.5", max: "187.25", first: "31.7" }),
    newParameter("p2", { q: "Q1712", prompt: "GRIP", kind: "choice", choices: "0 open, 1 closed, 3" }),
    newParameter("p3", { q: "1713", prompt: "FEED RATE", kind: "feed", first: "FAUTO" }),
  ],
  ...given,
});
const codes = (e: OwnEntry) => readOwn(e).problems.map(({ at, code }) => `${at} ${code}`);
const withParameter = (given: Parameters<typeof newParameter>[1]) =>
  entry({ parameters: [newParameter("p1", { q: "Q7", prompt: "X", ...given })] });
const block = (text: string) => {
  const s = parse(text).blocks[0]?.statement;
  if (s?.kind !== "cycle") throw new Error("no cycle");
  return s;
};

describe("a description", () => {
  test("is a cycle when every field can be used", () => {
    const { cycle, problems } = readOwn(entry());
    expect(problems).toEqual([]);
    expect(cycle).toEqual({
      number: 317,
      name: "BAR PULLER",
      parameters: [
        {
          q: "Q1711",
          prompt: "PULL LENGTH",
          kind: "length",
          range: [0.5, 187.25],
          bounded: true,
          choices: null,
          first: 31.7,
        },
        {
          q: "Q1712",
          prompt: "GRIP",
          kind: "choice",
          range: [-99999.9999, 99999.9999],
          bounded: false,
          choices: [
            { value: 0, meaning: "open" },
            { value: 1, meaning: "closed" },
            { value: 3, meaning: "" },
          ],
          first: 0,
        },
        {
          q: "Q1713",
          prompt: "FEED RATE",
          kind: "feed",
          range: [0, 99999.9999],
          bounded: false,
          choices: null,
          first: "auto",
        },
      ],
    });
  });

  test("may have no parameters, and an upper bound below zero alone", () => {
    expect(readOwn(entry({ parameters: [] })).cycle?.parameters).toEqual([]);
    const { cycle } = readOwn(withParameter({ kind: "feed", max: "-3" }));
    expect(cycle?.parameters[0]?.range).toEqual([-3, -3]);
    expect(cycle?.parameters[0]?.first).toBe(-3);
  });

  test.each([
    [{ number: "" }, "number missing"],
    [{ number: "31.7" }, "number noNumber"],
    [{ number: "0" }, "number noNumber"],
    [{ number: "31700" }, "number noNumber"],
    [{ number: "812" }, "number known"],
    [{ number: "880" }, "number known"],
    [{ number: "201" }, "number known"],
    [{ number: "247" }, "number known"],
    [{ number: "32" }, "number known"],
    [{ name: " " }, "name missing"],
    [{ name: "A ~ B" }, "name characters"],
    [{ name: "PULL Q5=3" }, "name characters"],
    [{ name: ".5" }, "name characters"],
    [{ name: "X".repeat(OWN_SIZES.name + 1) }, "name tooLong"],
  ])("%j: %s", (given, code) => expect(codes(entry(given))).toEqual([code]));

  test.each([
    [{ q: "" }, "p1.q missing"],
    [{ q: "R5" }, "p1.q noParameter"],
    [{ q: "QS5" }, "p1.q noParameter"],
    [{ q: "Q12345" }, "p1.q noParameter"],
    [{ prompt: "" }, "p1.prompt missing"],
    [{ prompt: "A ~" }, "p1.prompt characters"],
    [{ prompt: "A\u0007" }, "p1.prompt characters"],
    [{ min: "abc" }, "p1.min notANumber"],
    [{ min: "3", max: "2.9" }, "p1.max order"],
    [{ min: "3", first: "2.9" }, "p1.first outside"],
    [{ first: "FAUTO" }, "p1.first notANumber"],
    [{ kind: "choice" as const }, "p1.choices choices"],
    [{ kind: "choice" as const, choices: "open, closed" }, "p1.choices choices"],
    [{ kind: "choice" as const, choices: "1 a, 2 b, 1 c" }, "p1.choices choiceTwice"],
    [{ kind: "choice" as const, choices: "1 a, 2 b", first: "3" }, "p1.first outside"],
    [{ kind: "choice" as const, choices: Array.from({ length: 21 }, (_, i) => i).join() }, "p1.choices tooMany"],
  ])("a parameter with %j: %s", (given, code) => expect(codes(withParameter(given))).toEqual([code]));

  test.each([
    [{ number: "0317" }],
    [{ number: "199" }],
    [{ name: "SCHLEIFEN Ö 5/2 (A)" }],
    [{ name: "X".repeat(OWN_SIZES.name) }],
  ])("%j is nothing wrong", (given) => expect(codes(entry(given))).toEqual([]));

  test.each([
    { q: "QL3" },
    { q: "QR03" },
    { q: "17" },
    { q: "q17" },
    { min: "3", max: "3", first: "3" },
    { prompt: "A; B" },
  ])("a parameter with %j is nothing wrong", (given) => expect(codes(withParameter(given))).toEqual([]));

  test("a parameter stands in it once", () => {
    const parameters = [newParameter("p1", { q: "Q7", prompt: "A" }), newParameter("p2", { q: "7", prompt: "B" })];
    expect(codes(entry({ parameters }))).toEqual(["p2.q qTwice"]);
  });

  test("prompts hold what is typed to its range and choices", () => {
    const [length, grip, feed] = readOwn(entry()).cycle?.parameters.map(ownField) ?? [];
    const said = (field: typeof length, typed: string) => field && (readText(field, typed).issue?.code ?? "good");
    expect([
      said(length, "0.5"),
      said(length, "0.4"),
      said(length, ""),
      said(grip, "3"),
      said(grip, "2"),
      said(feed, "FMAX"),
    ]).toEqual(["good", "outOfRange", "missing", "good", "notAChoice", "good"]);
  });
});

describe("text", () => {
  test("is what the printer writes, and comes back as the same description", () => {
    const cycle = readOwn(entry({ name: "  BAR  PULLER " })).cycle;
    if (!cycle) throw new Error("not read");
    const program = parse("BEGIN PGM A MM\nEND PGM A MM\n");
    const text = print(withInserted(program, 1, ownStatement(cycle)));
    expect(text).toBe(
      "BEGIN PGM A MM\nCYCL DEF 317 BAR PULLER ~\nQ1711=+31.7 ;PULL LENGTH ~\nQ1712=+0 ;GRIP ~\nQ1713=FAUTO ;FEED RATE\nEND PGM A MM\n",
    );
    expect(parse(text).blocks[1]?.statement).toEqual(ownStatement(cycle));
  });

  test.each(["A; B", "NUR Ö", 'Ø 5 "x"', "Q5=3", "12.5", "-", ";", "50 % 'a'", "直径"])(
    "a prompt %s comes back",
    (prompt) => {
      const { cycle } = readOwn(withParameter({ prompt }));
      if (!cycle) throw new Error("not read");
      const statement = ownStatement(cycle);
      expect(parse(print(withInserted(parse(""), 0, statement))).blocks.map((b) => b.statement)).toEqual([statement]);
    },
  );

  test("a block proposes its description", () => {
    const s = block(
      "7 CYCL DEF 317 BAR PULLER ~\n  Q1711=+31.7 ;PULL LENGTH ~\n  Q1712=+Q5 ; GRIP ~\n  Q1713=FAUTO ;VORSCHUB ~\n  Q1711=+2 ;AGAIN\n",
    );
    const made = describedFrom(s, "c4");
    expect(made).toEqual({
      id: "c4",
      number: "317",
      name: "BAR PULLER",
      parameters: [
        newParameter("p1", { q: "Q1711", prompt: "PULL LENGTH", kind: "length", first: "31.7" }),
        newParameter("p2", { q: "Q1712", prompt: "GRIP" }),
        newParameter("p3", { q: "Q1713", prompt: "VORSCHUB", kind: "feed", first: "FAUTO" }),
      ],
    });
    expect(readOwn(made).cycle).not.toBeNull();
  });

  test("words that only look like a kind say nothing of it", () => {
    const s = block("CYCL DEF 317 A ~\nQ1=+1 ;TANGENT ~\nQ2=+1 ;SETTING ANGLE ~\nQ3=+1 ;FEEDER NO. ~\nQ4=+1\n");
    expect(describedFrom(s, "c").parameters.map((p) => p.kind)).toEqual(["number", "angle", "number", "number"]);
  });
});

describe("the list", () => {
  test("of two with one number the first is used, and the second says so", () => {
    const list = [entry(), entry({ id: "c2", number: "0317", name: "OTHER" }), entry({ id: "c3", number: "318" })];
    const { rows, cycles } = readLibrary(list);
    expect(rows.get("c2")?.problems).toEqual([{ at: "number", code: "twice", text: "317" }]);
    expect([...cycles].map(([number, { name }]) => [number, name])).toEqual([
      [317, "BAR PULLER"],
      [318, "BAR PULLER"],
    ]);
    expect(freeCycle(list, 317)).toBe(319);
    expect(freeCycle([], 880)).toBe(881);
  });

  test("goes into a file and comes back, with what is wrong in it", () => {
    const list = [
      entry(),
      entry({ id: "c2", number: "12x", name: 'A "B"', parameters: [] }),
      withParameter({ first: "1+2", min: "-0" }),
    ];
    const read = readLibraryFile(`\uFEFF${writeLibrary(list)}`);
    if (!("entries" in read)) throw new Error("not read");
    const withoutId = <T extends { readonly id: string }>({ id: _, ...rest }: T) => rest;
    const bare = (entries: typeof list) =>
      entries.map((e) => ({ ...withoutId(e), parameters: e.parameters.map(withoutId) }));
    expect(bare([...read.entries])).toEqual(bare(list));
    expect(read.leftOut).toEqual([]);
  });

  test("a file reports its unknown names", () => {
    const read = readLibraryFile(
      '{"cycles":[{"number":317,"colour":1,"name":"A","parameters":[{"q":7,"prompt":"B","kind":"depth","min":1.5}]}]}',
    );
    expect(read).toEqual({
      entries: [
        { id: "c1", number: "317", name: "A", parameters: [newParameter("p1", { q: "7", prompt: "B", min: "1.5" })] },
      ],
      leftOut: ["colour", "kind depth"],
    });
  });

  const many = (n: number) => Array.from({ length: n }, () => ({}));
  test.each([
    ["Dear sirs", { problem: "notALibrary" }],
    ["[]", { problem: "notALibrary" }],
    ['{"cycles":{}}', { problem: "notALibrary" }],
    ['{"cycles":[]}', { problem: "nothing" }],
    [JSON.stringify({ cycles: many(OWN_SIZES.cycles + 1) }), { problem: "tooMany" }],
    ['{"cycles":[{"number":317},{"number":true}]}', { problem: "wrongCycle", at: 2 }],
    [JSON.stringify({ cycles: [{ parameters: many(OWN_SIZES.parameters + 1) }] }), { problem: "wrongCycle", at: 1 }],
    [JSON.stringify({ cycles: [{ name: "x".repeat(501) }] }), { problem: "wrongCycle", at: 1 }],
  ])("%.40s is refused", (text, problem) => expect(readLibraryFile(text)).toEqual(problem));

  test("a description of the same number takes the place of the old one", () => {
    const made = mergedLibrary(
      [entry(), entry({ id: "c2", number: "318" })],
      [
        entry({ id: "c1", number: "318", name: "NEW" }),
        entry({ id: "c2", number: "320" }),
        entry({ id: "c3", number: "320", name: "LAST" }),
      ],
    );
    expect(made.list.map(({ id, number, name }) => `${id} ${number} ${name}`)).toEqual([
      "c1 317 BAR PULLER",
      "c2 318 NEW",
      "c3 320 LAST",
    ]);
    expect([made.replaced, made.added]).toEqual([1, 1]);
  });
});
