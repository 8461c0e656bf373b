import { Fragment } from "react";
import { splitNegativeNumbers } from "./negative-numbers.ts";
import "./unbroken.css";

/** A text whose negative numbers stay on one line, such as Z-38. */
export const Unbroken = ({ text }: { readonly text: string }) =>
  splitNegativeNumbers(text).map((piece, k) =>
    k % 2 === 1 ? (
      <span key={k} className="unbroken">
        {piece}
      </span>
    ) : (
      <Fragment key={k}>{piece}</Fragment>
    ),
  );
