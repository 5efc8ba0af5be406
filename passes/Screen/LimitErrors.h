// The numbered remark of a pass that is asked for more than it does: a longer blur, more rounds. Docs: docs/errors.md.
#pragma once

#include "RenderGraphNotes.h"

#include <string>

namespace Drydock
{

enum ELimitError : int
{
	WarnLimited = 2110, // what was taken in the place of a setting or console variable
};

/** Adds a warning to the run. The argument Where is the effect; Message: the value asked for, the value taken in its
 * place, and why. */
inline void AddLimitNote(FRDGBuilder& GraphBuilder, const std::string& Where, const std::string& Message)
{
	FDiagnostic Note;
	Note.Severity = ESeverity::Warning;
	Note.Code = WarnLimited;
	Note.Where = Where;
	Note.Message = Message;
	AddGraphNote(GraphBuilder, Note);
}

} // namespace Drydock
