import type { ComponentProps } from "react";
import { lazyPart } from "../../base/parts.ts";
import { promptMoreSlot } from "../slots.ts";
import "./prompt-more.css";

const PromptMore = lazyPart(async () => ({ default: await promptMoreSlot.fetch() }));

/** Link to a guide page, loaded when first shown. Its place is kept free until then: the fields below it stay put. */
export const LazyPromptMore = (props: ComponentProps<typeof PromptMore>) => (
  <span className="prompt-ways">
    <PromptMore {...props} />
  </span>
);
