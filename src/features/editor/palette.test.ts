import { expect, test } from "vitest";
import { ncWordOf, palette, plainName } from "./palette.ts";

test("every block of the palette has the word that the program begins it with", () => {
  expect(Object.fromEntries(palette.map((offered) => [offered.kind, ncWordOf(offered, "en")]))).toEqual({
    L: "L",
    C: "C",
    CC: "CC",
    CR: "CR",
    CT: "CT",
    LP: "LP",
    CP: "CP",
    CTP: "CTP",
    RND: "RND",
    chamfer: "CHF",
    approach: "APPR",
    departure: "DEP",
    cycle: "CYCL DEF",
    cycleCall: "CYCL CALL",
    contour: "CYCL DEF",
    selectContour: "SEL CONTOUR",
    undercut: "UDC",
    groove: "GRV",
    toolCall: "TOOL CALL",
    spin: "FUNCTION TURNDATA SPIN",
    mode: "FUNCTION MODE TURN",
    turnCorrection: "FUNCTION TURNDATA CORR",
    turnBlank: "FUNCTION TURNDATA BLANK",
    functions: "M",
    toolDefinition: "TOOL DEF",
    label: "LBL",
    call: "CALL LBL",
    assign: "Q",
    stop: "STOP",
    structure: "*",
    comment: ";",
    begin: "BEGIN PGM",
    blankCylinder: "BLK FORM CYLINDER",
    blankRotation: "BLK FORM ROTATION",
    blankBox: "BLK FORM",
    end: "END PGM",
  });
});

test.each([
  ["Turning spindle (TURNDATA SPIN)", "Turning spindle"],
  ["车削主轴（TURNDATA SPIN）", "车削主轴"],
  ["Straight line", "Straight line"],
])("%s is %s beside its word", (name, plain) => expect(plainName(name)).toBe(plain));
