"""The names of the topics in one: those of the stub of each."""

from solver.exact.analog import *
from solver.exact.classical import *
from solver.exact.compensators import *
from solver.exact.design import *
from solver.exact.digital import *
from solver.exact.frequency import *
from solver.exact.functions import *
from solver.exact.linear_algebra import *
from solver.exact.loops import *
from solver.exact.modelling import *
from solver.exact.multivariable import *
from solver.exact.optimal import *
from solver.exact.representation import *
from solver.exact.root_locus import *
from solver.exact.stability import *
from solver.exact.structure import *
from solver.exact.time_response import *
from solver.exact.transforms import *
from solver.exact.variations import *
