// Keeps whole texts: a config is small, and a text needs no inverse of any edit.
#include "Live/EditHistory.h"

#include "Live/LiveErrors.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

namespace Drydock
{

namespace
{

constexpr size_t MaxHistoryBytes = 64'000'000;
constexpr const char* RecordFormat = "drydock-live";

FError MakeEditError(const std::string& Message)
{
	return FError({.Code = ErrorBadEdit, .Message = Message}, ExitUsage);
}

FError MakeRecordError(const std::string& File, size_t Line, const std::string& Message)
{
	return FError(
		{.Code = ErrorBadRecord, .Message = Message, .File = File, .Line = static_cast<int>(Line), .Where = "--replay"},
		ExitUsage);
}

FJsonValue ReadLine(const std::string& Text, const std::string& File, size_t Line)
{
	std::vector<FDiagnostic> Faults;
	bool bSyntaxError = false;
	FJsonValue Value = ParseJson(Text, File, Faults, bSyntaxError);
	if (bSyntaxError || !Faults.empty() || Value.Type != EJsonType::Object)
	{
		throw MakeRecordError(File, Line, "this line is not a JSON object, as those of a session's record are");
	}
	return Value;
}

std::string MakeFirstLine(const std::string& File, const std::string& Text)
{
	FJsonWriter Writer;
	Writer.Object({{"format", RecordFormat}, {"formatVersion", 1}, {"config", File}, {"text", Text}});
	return Trim(Writer.GetText());
}

/** The name of a drag that sets these places; empty: it is none. */
std::string MakeDrag(const std::string& Name, const std::vector<FConfigEdit>& Edits)
{
	std::string Drag = Name;
	for (const FConfigEdit& Edit : Edits)
	{
		if (Name.empty() || !Edit.Value || Edit.Pointer.ends_with("/-"))
		{
			return "";
		}
		Drag += "\n" + Edit.Pointer;
	}
	return Drag;
}

} // namespace

FEditHistory::FEditHistory(std::string InFile, std::string Start)
	: File(std::move(InFile))
	, First(MakeFirstLine(File, Start))
{
	Steps.push_back({std::move(Start), ""});
}

std::string FEditHistory::Reset(const std::string& Pointer) const
{
	const std::optional<std::string> Before = FindPlace(GetStart(), Pointer);
	return Before == FindPlace(GetText(), Pointer) ? GetText() : ApplyEdits(GetText(), {{Pointer, Before}});
}

FEditHistory::FNext FEditHistory::Plan(const FJsonValue& Change) const
{
	FNext Next{.Text = GetText(), .Step = Now + 1, .Line = WriteJson(Change)};
	if (const FJsonValue* const Edits = Change.Find("edits"))
	{
		const std::vector<FConfigEdit> Read = ReadEdits(*Edits);
		Next.Text = ApplyEdits(GetText(), Read);
		Next.Drag = MakeDrag(Change.GetString("drag"), Read);
	}
	else if (const bool bUndo = Change.Find("undo") != nullptr; bUndo || Change.Find("redo") != nullptr)
	{
		if (bUndo ? !CanUndo() : !CanRedo())
		{
			throw MakeEditError(bUndo ? "there is nothing to undo" : "there is nothing to do again");
		}
		Next.Step = bUndo ? Now - 1 : Now + 1;
		Next.Text = Steps[Next.Step].Text;
		Next.bForward = false;
	}
	else if (const FJsonValue* const Place = Change.Find("reset"))
	{
		Next.Text = Place->Type == EJsonType::String ? Reset(Place->String) : GetStart();
	}
	else if (const FJsonValue* const Text = Change.Find("text"))
	{
		Next.Text = Text->String;
	}
	else
	{
		throw MakeEditError("expected one of edits, undo, redo, reset and text");
	}
	return Next;
}

void FEditHistory::Take(const FNext& Next)
{
	++Revision;
	const bool bDragged = !Next.Drag.empty() && Next.Drag == LastDrag && Steps[Now].Drag == Next.Drag && !CanRedo();
	LastDrag = Next.Drag;
	if (bDragged)
	{
		Steps[Now].Text = Next.Text;
		Lines.back() = Next.Line;
		return;
	}
	Lines.push_back(Next.Line);
	if (Next.bForward)
	{
		Steps.resize(Next.Step);
		Steps.push_back({Next.Text, Next.Drag});
	}
	Now = Next.Step;
	NumBytes += Next.Line.size() + Next.Text.size() + Next.Drag.size();
	if (NumBytes > MaxHistoryBytes && Now > 0)
	{
		Steps = {Steps.front(), Steps[Now]};
		Now = 1;
		Lines = {"{\"text\": " + FJsonWriter::Quote(GetText()) + "}"};
		NumBytes = 0;
	}
}

std::string FEditHistory::GetRecord() const
{
	std::string Record = First + "\n";
	for (const std::string& Line : Lines)
	{
		Record += Line + "\n";
	}
	return Record;
}

FEditHistory FEditHistory::Replay(const std::string& Record, const std::string& RecordFile)
{
	const std::vector<std::string> Lines = SplitText(Record);
	const FJsonValue First = Lines.empty() ? FJsonValue() : ReadLine(Lines[0], RecordFile, 1);
	if (First.GetString("format") != RecordFormat || First.GetString("config").empty())
	{
		throw MakeRecordError(RecordFile, 1, "this is not the record of a session of drydock live");
	}
	FEditHistory History(First.GetString("config"), First.GetString("text"));
	for (size_t Index = 1; Index < Lines.size(); ++Index)
	{
		try
		{
			History.Take(History.Plan(ReadLine(Lines[Index], RecordFile, Index + 1)));
		}
		catch (const FError& Error)
		{
			throw MakeRecordError(RecordFile, Index + 1, Error.GetDiagnostics().front().Message);
		}
	}
	return History;
}

} // namespace Drydock
