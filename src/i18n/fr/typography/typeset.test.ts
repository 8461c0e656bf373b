import { expect, test } from "vitest";
import { typeset } from "./typeset.ts";

test("no line breaks before two-part marks nor inside the quotation marks", () => {
  expect(typeset("« G'50 » : quoi ? Oui ; 12,5 % !")).toBe(
    "«\u00a0G’50\u00a0»\u00a0: quoi\u00a0? Oui\u00a0; 12,5\u00a0%\u00a0!",
  );
  expect(typeset("Opération d'usinage (0/1/2/3)?")).toBe("Opération d’usinage (0/1/2/3)\u00a0?");
});

test("texts within texts and texts with data keep their shape, and the data their apostrophes", () => {
  const { list, of } = typeset({
    list: ["l'un"],
    of: { said: (text: string, n: number) => `${text} : ${n} ?` },
    printed: true,
  });
  expect([list, of.said(";AVANCE D'EBAUCHE", 3.5)]).toEqual([["l’un"], ";AVANCE D'EBAUCHE\u00a0: 3.5\u00a0?"]);
});
