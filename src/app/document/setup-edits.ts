import type { Job } from "../../program/job/job.ts";
import type { SetupPlace } from "../../program/job/setup-places.ts";
import { proposalAt } from "../../program/job/setup.ts";
import { withPlace } from "../../program/job/setup-place.ts";
import { closeStep } from "./steps.ts";
import { changeJob } from "./store.ts";
import { toolTable } from "./work-tools.ts";

/** The job with what is proposed for a field that is set now, so that another proposal is noticed later. */
function withProposal(job: Job, place: SetupPlace, isSet: boolean): Job {
  const { proposals: { [place]: _, ...others } = {}, ...bare } = job;
  const proposals = isSet ? { ...others, [place]: proposalAt(job, place, toolTable().tools) } : others;
  return Object.keys(proposals).length > 0 ? { ...bare, proposals } : bare;
}

/** Sets a field of the set-up: it is the operator's and stays. An empty text restores the proposal. */
export const setPlace = (place: SetupPlace, text: string): void =>
  changeJob((job) => {
    const next = withPlace(job, place, text);
    return next === job ? job : withProposal(next, place, text.trim() !== "");
  }, place);

/** Sets a field of the set-up by a button, as its own step of undo. */
export function takePlace(place: SetupPlace, text: string): void {
  closeStep();
  setPlace(place, text);
  closeStep();
}
