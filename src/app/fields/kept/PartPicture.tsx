import type { Thumbnail } from "../../../view/thumbnail.ts";

/** Half section of a finished part inside its blank. Decorative, since the name is next to it. */
export function PartPicture({ of }: { readonly of: Thumbnail | undefined }) {
  return (
    <svg className="part-picture" viewBox={(of?.box ?? [0, 0, 1, 1]).join(" ")} aria-hidden="true" focusable="false">
      {of?.plane && <path className="part-plane" d={of.plane} />}
      {of && !of.plane && (
        <>
          <path className="part-blank" d={of.blank} />
          <path className="part-section" d={of.part} />
          <path className="part-outside" d={of.part} transform="scale(1 -1)" />
          <path className="part-axis" d={`M${of.box[0]} 0H${of.box[0] + of.box[2]}`} />
        </>
      )}
    </svg>
  );
}
