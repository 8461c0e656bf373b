import { lazyPart } from "../../base/parts.ts";
import { promptMoreSlot } from "../slots.ts";

/** The way to a page of the guide, fetched when it is first shown. */
export const MoreLater = lazyPart(async () => ({ default: await promptMoreSlot.fetch() }));
