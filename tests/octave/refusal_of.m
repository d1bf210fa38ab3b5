function words = refusal_of(question)
% What a question is refused with; empty if it is answered.
  words = '';
  try
    question();
  catch problem
    words = problem.message;
  end
end
