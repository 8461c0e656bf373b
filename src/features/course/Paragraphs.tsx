import { Fragment } from "react";
import { Said, SaidOnPage } from "../../app/fields/said/Said.tsx";
import { numbersApart } from "./numbers-apart.ts";
import "./paragraphs.css";

/** No line ends before a mark that French sets apart, nor behind its opening quote. */
const together = (text: string): string => text.replaceAll(/ (?=[?!:;»%])|(?<=«) /g, "\u00a0");

/** A text in which no number breaks. */
const unbroken = (text: string) =>
  numbersApart(text).map((piece, k) =>
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
  /** Texts of the pages before: words of the glossary lead there where they are used first. Absent: none does. */
  readonly before?: readonly string[];
}

/** A text of the course: its paragraphs, which empty lines part. */
export function Paragraphs({ text, before }: Props) {
  const paragraphs = text.split(/\n\s*\n/).map(together);
  const said = (plain: boolean) =>
    paragraphs.map((each, i) => <p key={i}>{plain ? unbroken(each) : <Said text={each} plain={unbroken} />}</p>);
  return before ? (
    <SaidOnPage texts={paragraphs} before={before}>
      {said(false)}
    </SaidOnPage>
  ) : (
    said(true)
  );
}
