import { fetchTexts } from "../../src/app/base/settings/loaded-texts.ts";
import type { Language } from "../../src/i18n/languages.ts";
import { createRoot } from "react-dom/client";
import "../../src/app/base/styles/base.css";
import "../../src/app/base/styles/dialog.css";
import { HelpPicture } from "../../src/app/pictures/help/HelpPicture.tsx";
import { catalogue } from "../../src/cycles/index.ts";
import { contourFrom } from "../../src/kernel/contour/contour.ts";
import { axial, diameter, toRadius } from "../../src/kernel/units.ts";

const ask = new URLSearchParams(location.search);
const number = Number(ask.get("cycle") ?? 812);
const width = Number(ask.get("width") ?? 380),
  height = Number(ask.get("height") ?? 270);
if (ask.get("theme")) document.documentElement.dataset["theme"] = ask.get("theme")!;
const cycle = catalogue.find((c) => c.number === number)!;
const at = (z: number, d: number) => ({ kind: "line", to: { z: axial(z), r: toRadius(diameter(d)) } }) as const;
const contour =
  cycle.contour === "free"
    ? contourFrom([
        at(-20, 75),
        at(-20, 50),
        { kind: "round", size: 2 },
        at(-25, 20),
        { kind: "round", size: 2 },
        at(0, 20),
      ]).segments
    : null;
const values = {
  ...Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, p.example])),
  ...JSON.parse(ask.get("values") ?? "{}"),
};
const list = ask.get("q") ? ask.get("q")!.split(",") : ["", ...Object.keys(cycle.params)];

const language = (ask.get("language") ?? "en") as Language;
await fetchTexts(language);
createRoot(document.getElementById("root")!).render(
  <div style={{ display: "flex", flexWrap: "wrap", gap: 8, padding: 8 }}>
    {list.map((q) => (
      <figure key={q} style={{ border: "1px solid var(--line)" }}>
        <figcaption className="small">{q || "none"}</figcaption>
        <div className="help-slot" style={{ width, height }}>
          <HelpPicture
            cycle={cycle}
            values={values}
            given={{ contour, start: null }}
            activeQ={q || null}
            language={language}
          />
        </div>
      </figure>
    ))}
  </div>,
);
