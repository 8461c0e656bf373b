import { Fragment } from "react";
import { GlossaryText, GlossaryScope } from "../../app/fields/said/GlossaryText.tsx";
import { splitNegativeNumbers } from "./negative-numbers.ts";
import "./paragraphs.css";

/** Non-breaking spaces before French high punctuation, and after the opening quote. */
const together = (text: string): string => text.replaceAll(/ (?=[?!:;»%])|(?<=«) /g, "\u00a0");

/** A text whose numbers do not break. */
const unbroken = (text: string) =>
  splitNegativeNumbers(text).map((piece, k) =>
    k % 2 === 1 ? (
      <span key={k} className="unbroken">
        {piece}
      </span>
    ) : (
      <Fragment key={k}>{piece}</Fragment>
    ),
  );

interface Props {
  readonly text: string;
  /** Texts of the previous pages: a glossary term links where it is used first. Absent: no links. */
  readonly before?: readonly string[];
}

/** A text of the course, with paragraphs at empty lines. */
export function Paragraphs({ text, before }: Props) {
  const paragraphs = text.split(/\n\s*\n/).map(together);
  const said = (plain: boolean) =>
    paragraphs.map((each, i) => (
      <p key={i}>{plain ? unbroken(each) : <GlossaryText text={each} plain={unbroken} />}</p>
    ));
  return before ? (
    <GlossaryScope texts={paragraphs} before={before}>
      {said(false)}
    </GlossaryScope>
  ) : (
    said(true)
  );
}
