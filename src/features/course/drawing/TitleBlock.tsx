import type { SheetTitle } from "../../../view/drawing/drawing-svg.ts";

/** The title block of a workshop drawing, and its notes. */
export function TitleBlock({ title: { name, facts, notes } }: { readonly title: SheetTitle }) {
  return (
    <>
      <dl className="workshop-title">
        <div className="workshop-name">
          <dt>{name.label}</dt>
          <dd>{name.text}</dd>
        </div>
        {facts.map(({ label, text }) => (
          <div key={label}>
            <dt>{label}</dt>
            <dd>{text}</dd>
          </div>
        ))}
      </dl>
      <p className="workshop-notes">{notes.join(" · ")}</p>
    </>
  );
}
