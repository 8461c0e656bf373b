import { Fragment } from "react";
import { splitNegativeNumbers } from "./negative-numbers.ts";
import "./unbroken.css";

/** Spaces before units and French high punctuation, after an opening quote, and around an equals sign. */
const JOINTS = [
  " (?=[?!:;»%])|(?<=«) ",
  String.raw`(?<=\d) (?=(?:[mcµ]?m[²³]?|[mcµ]?m\/(?:min|rev|U|tr)|kW|s)(?!\p{L}))`,
  String.raw` (?=[=≈] )|(?<=[=≈]) (?=[\d√])`,
];
const joints = new RegExp(JOINTS.join("|"), "gu");

/** A text whose numbers stay on one line, with their sign, such as Z-38, and their unit. */
export const Unbroken = ({ text }: { readonly text: string }) =>
  splitNegativeNumbers(text.replaceAll(joints, "\u00a0")).map((piece, k) =>
    k % 2 === 1 ? (
      <span key={k} className="unbroken">
        {piece}
      </span>
    ) : (
      <Fragment key={k}>{piece}</Fragment>
    ),
  );
