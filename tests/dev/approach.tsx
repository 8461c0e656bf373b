import { useState } from "react";
import { createRoot } from "react-dom/client";
import { ApproachDialog } from "../../src/features/editor/approach/ApproachDialog.tsx";
import { entryAt } from "../../src/app/findings/entry.ts";
import { PlaneView } from "../../src/app/pictures/plane/PlaneView.tsx";
import { clock } from "../../src/app/base/clock.ts";
import { createPlaybackStore } from "../../src/app/calculation/playback-store.ts";
import { followAppearance } from "../../src/app/base/settings/appearance.ts";
import { fetchTexts } from "../../src/app/base/settings/loaded-texts.ts";
import { useSettings } from "../../src/app/base/settings/settings.ts";
import "../../src/app/base/styles/base.css";
import "../../src/app/base/styles/layout.css";
import "../../src/app/base/styles/dialog.css";
import { withBlock } from "../../src/nc/edit.ts";
import { parse } from "../../src/nc/parse.ts";
import { approachContext } from "../../src/program/edits/approach-context.ts";
import { run } from "../../src/program/run/run.ts";
import { simulate } from "../../src/sim/simulate.ts";
import linear from "../programs/milling-linear.h?raw";
import circular from "../programs/milling-circular.h?raw";

/* Dialog of one APPR or DEP block beside the plane view: `?circular`, `?block=7`, `?view` alone, `?dark`. */
const asked = new URLSearchParams(location.search);
followAppearance();
if (asked.has("dark")) document.documentElement.dataset["theme"] = "dark";
const playback = createPlaybackStore(clock);
const shop = { tools: [], mills: [{ T: 1, NAME: "MILL", R: 10 }], rapid: 10000 };

function Page() {
  const [program, change] = useState(() =>
    parse((asked.get("text") ?? (asked.has("circular") ? circular : linear)).replaceAll("|", "\n")),
  );
  const made = run(program, shop);
  const index = Number(asked.get("block") ?? program.blocks.findIndex((b) => b.statement.kind === "approach"));
  const statement = program.blocks[index]?.statement;
  return (
    <main style={{ display: "grid", gridTemplateColumns: asked.has("view") ? "1fr" : "400px 1fr", height: "100vh" }}>
      {!asked.has("view") && statement?.kind === "approach" && (
        <ApproachDialog
          statement={statement}
          context={approachContext(program, index, made, {})}
          onChange={(next) => change(withBlock(program, index, next))}
          found={made.issues
            .filter((f) => f.line !== null && f.block === (made.approaches.find((a) => a.index === index)?.block ?? -1))
            .map((f) => entryAt(f.issue, ("at" in f.issue ? f.issue.at : undefined) ?? null, f.block))}
        />
      )}
      <PlaneView result={{ run: made, simulation: simulate(made) }} dimmed={false} playback={playback} clock={clock} />
    </main>
  );
}

const root = document.getElementById("root");
void fetchTexts(useSettings.getState().language).then(() => {
  if (root) createRoot(root).render(<Page />);
});
