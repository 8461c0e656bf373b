import { Fragment } from "react";
import "./keys.css";

/** Keys pressed together, with their names in the screen language. */
export function KeyCombination({
  keys,
  names,
}: {
  readonly keys: string;
  readonly names: Readonly<Record<string, string>>;
}) {
  return (
    <span>
      {keys.split(" ").map((key, i) => (
        <Fragment key={key}>
          {i > 0 && "+"}
          <kbd>{names[key] ?? key}</kbd>
        </Fragment>
      ))}
    </span>
  );
}
