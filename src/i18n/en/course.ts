import type { Shape } from "../shape.ts";

/**
 * The pages of the course: the list of lessons, a lesson with its picture, how far one has come. Numbers arrive as
 * text.
 */
export const course = {
  title: "Course",
  lead:
    "Turning with the cycles of the control, from the first shoulder to a whole part. Each lesson is a few pages with a picture that " +
    "moves, and tasks in the real editor.",
  entrance: {
    name: "Course",
    about: "Lessons with tasks, from the first shoulder to a whole part",
    goOn: (lesson: string) => `Go on with lesson ${lesson}`,
  },
  lessons: "Lessons",
  lesson: (n: string) => `Lesson ${n}`,
  openLesson: (n: string, title: string) => `Lesson ${n}, ${title}`,
  begin: "Begin with lesson 1",
  goOn: (n: string, title: string) => `Go on: lesson ${n}, ${title}`,
  passed: (n: string, of: string) => `${n} of ${of} tasks passed`,
  allPassed: "All tasks passed",
  noTasks: "No tasks",
  read: "read",
  here: "You are here",
  states: {
    new: "not begun",
    tried: "tried",
    alone: "passed alone",
    hints: "passed with hints",
    solution: "passed with the solution shown",
  },
  kinds: { make: "Program it", fault: "Find the fault", predict: "Predict", drawing: "From a drawing" },

  missing: "This lesson is not part of the course.",
  toList: "All lessons",
  pages: "Pages of the lesson",
  page: (n: string) => `Page ${n}`,
  pageOf: (n: string, of: string) => `Page ${n} of ${of}`,
  tasks: "Tasks",
  previous: "Back",
  next: "Next",
  toTasks: "To the tasks",
  nextLesson: (n: string, title: string) => `Next lesson: ${n}, ${title}`,
  example: "Open the example in the editor",
  exampleLead: "The program of this lesson, to try values in. Your work is kept; Back leads here again.",
  noTasksYet: "This lesson has no tasks.",

  picture: {
    name: "Picture of the lesson",
    working: "The picture is being made.",
    failed: "The picture could not be made.",
    play: "Play the picture",
    pause: "Hold the picture",
    first: "To the start",
    back: "One move back",
    forward: "One move on",
    scrub: "Moment of the picture",
    program: "The program of the picture",
    openProgram: "Open this program in the editor",
  },

  anew: "Begin the course anew",
  cancel: "Cancel",
  begunAnew: "The course begins anew. Undo brings back what was reached.",
  damaged: "What was reached in the course could not be read. It was set aside, and the course begins anew.",
  notKept:
    "This browser does not keep what is reached in the course. Save everything as one file in the settings before you close the page.",
};

export type CourseTexts = Shape<typeof course>;
