import { Fragment } from "react";
import "./paragraphs.css";

/** No line ends before a mark that French sets apart, nor behind its opening quote. */
const together = (text: string): string => text.replaceAll(/ (?=[?!:;»%])|(?<=«) /g, "\u00a0");

/** A word in which a minus stands before a digit, such as Z-35: it would break behind the minus. */
const NUMBER = /(\S*-\d\S*)/;

/** A text of the course: its paragraphs, which empty lines part. */
export function Paragraphs({ text }: { readonly text: string }) {
  return (
    <>
      {text.split(/\n\s*\n/).map((each, i) => (
        <p key={i}>
          {together(each).split(NUMBER).map((piece, k) =>
            NUMBER.test(piece) ? <span key={k} className="unbroken">{piece}</span> : <Fragment key={k}>{piece}</Fragment>
          )}
        </p>
      ))}
    </>
  );
}
