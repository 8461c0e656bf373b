import type { ReactNode } from "react";
import { type GuidePath, showGuide } from "../../app/place/place.ts";

/** A link to another page of the guide, in a list of links. */
export function GuideButton({ to, children }: { readonly to: GuidePath; readonly children: ReactNode }) {
  return (
    <li>
      <button type="button" className="guide-link" onClick={() => showGuide(...to)}>
        {children}
      </button>
    </li>
  );
}
