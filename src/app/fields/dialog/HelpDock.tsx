import { useEffect, type ReactNode } from "react";
import { Icon } from "../../base/Icon.tsx";
import { useMedia } from "../../base/use-media.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { usePlace } from "../../place/place.ts";
import {
  enlargePicture,
  holdDrawingDock,
  holdHelpDock,
  useDrawingDock,
  useHelpDock,
  useLargePicture,
} from "./help-dock.ts";

function useEnlarged() {
  const strip = useMedia("strip");
  const { large } = useLargePicture();
  useEffect(
    () =>
      usePlace.subscribe((now, before) => {
        if (now.focus !== before.focus || now.prompt !== before.prompt || now.section !== before.section)
          enlargePicture(false);
      }),
    [],
  );
  return { strip, enlarged: strip && large };
}

/**
 * Centre of a workplace; its class says whether a help picture is docked, and whether a drawing is shown. A `:has()`
 * rule would be re-evaluated for the whole view with each node added to the picture.
 */
export function Centre({ children }: { readonly children: ReactNode }) {
  const docked = useHelpDock((d) => d.filled);
  const drawn = useDrawingDock((d) => d.filled);
  const t = useTexts().lathe;
  const { strip, enlarged } = useEnlarged();
  return (
    <div
      className={`centre${docked ? " docked" : ""}${drawn ? " drawn" : ""}`}
      data-large={enlarged}
      onKeyDown={(event) => {
        if (event.key === "Escape" && !event.defaultPrevented) enlargePicture(false);
      }}
    >
      {strip && (
        <button
          type="button"
          className="picture-switch"
          aria-label={enlarged ? t.reduce : t.enlarge}
          title={enlarged ? t.reduce : t.enlarge}
          aria-expanded={enlarged}
          onClick={() => enlargePicture(!enlarged)}
        >
          <Icon name={enlarged ? "reduce" : "enlarge"} />
        </button>
      )}
      {children}
      <div className="drawing-dock" ref={holdDrawingDock} />
    </div>
  );
}

/** Pane next to the view for the help picture of the open prompt, where the screen has room. */
export function HelpDock() {
  const docked = useMedia("docked");
  return docked && <div className="help-dock" ref={holdHelpDock} />;
}
