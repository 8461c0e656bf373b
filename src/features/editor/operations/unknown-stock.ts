import { ringOf } from "../../../program/job/requested-job.ts";

/** Where the program states no blank: some cylinder, only to compare tools. Nothing of it is written or suggested. */
export const UNKNOWN_STOCK = [ringOf({ outside: "80", bore: "30", length: "100", allowance: "0" })];
