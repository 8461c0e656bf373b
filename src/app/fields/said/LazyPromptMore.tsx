import { lazyPart } from "../../base/parts.ts";
import { promptMoreSlot } from "../slots.ts";

/** Link to a guide page, loaded when first shown. */
export const LazyPromptMore = lazyPart(async () => ({ default: await promptMoreSlot.fetch() }));
