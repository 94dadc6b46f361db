"""What tests share: asking tasks, generated systems, sample problems and pages, students' answers."""
