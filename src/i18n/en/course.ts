import type { Shape } from "../shape.ts";

/**
 * The pages of the course: the list of lessons, a lesson with its picture, the progress. Numbers arrive as
 * text.
 */
export const course = {
  title: "Course",
  lead:
    "Turning with the cycles of the control, from the first shoulder to a complete part. Each lesson has a few pages with an animated " +
    "picture, and exercises in the real editor.",
  entrance: {
    name: "Learn",
    about: "Lessons with exercises, from the first shoulder to a complete part",
    goOn: (lesson: string) => `Continue with lesson ${lesson}`,
  },
  lessons: "Lessons",
  lesson: (n: string) => `Lesson ${n}`,
  openLesson: (n: string, title: string) => `Lesson ${n}, ${title}`,
  begin: (n: string) => `Start with lesson ${n}`,
  goOn: (n: string, title: string) => `Continue: lesson ${n}, ${title}`,
  passed: (n: string, of: string) => `${n} of ${of} exercises passed`,
  read: "read",
  states: {
    new: "not started",
    tried: "tried",
    alone: "passed unaided",
    hints: "passed with hints",
    solution: "passed with the solution shown",
  },
  kinds: { make: "Program it", fault: "Find the fault", predict: "Predict", drawing: "From a drawing" },

  missing: "This lesson is not part of the course.",
  toList: "All lessons",
  pages: "Pages of the lesson",
  page: (n: string) => `Page ${n}`,
  pageOf: (n: string, of: string) => `Page ${n} of ${of}`,
  tasks: "Exercises",
  previous: "Back",
  next: "Next",
  toTasks: "To the exercises",
  nextLesson: (n: string, title: string) => `Next lesson: ${n}, ${title}`,
  example: "Open the example in the editor",
  exampleLead: "The program of this lesson, for trying out values. Your own programs are kept; Back returns here.",
  noTasksYet: "This lesson has no exercises.",

  picture: {
    name: "Picture of the lesson",
    working: "The picture is being calculated.",
    failed: "The picture could not be calculated.",
    play: "Play",
    pause: "Pause",
    first: "To the start",
    back: "Previous move",
    forward: "Next move",
    scrub: "Position in the animation",
    program: "Program shown in the picture",
    openProgram: "Open this program in the editor",
  },

  question: {
    name: "Question",
    check: "Check",
    checking: "Checking …",
    right: "Correct.",
    wrong: "Not yet.",
    half: "That is half of it: a radius?",
    twice: "That is twice as much: a diameter?",
    shown: "The picture now shows this case.",
    failed: "The answer could not be checked. Try again.",
    lacks: "Type a number.",
    answered: "Answered",
    yours: "Your answer",
  },

  restart: "Restart course",
  cancel: "Cancel",
  restarted: "The course was restarted. Undo restores your progress.",
  damaged:
    "Your progress in the course could not be read. The damaged data were set aside, and the course starts over.",
  notKept: "This browser does not store your progress. Back up your data in the settings before you close the page.",
};

export type CourseTexts = Shape<typeof course>;
