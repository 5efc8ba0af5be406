// Writes a matrix as JSON.
#include "Matrix/MatrixSummary.h"
#include "Matrix/MatrixTable.h"
#include "Matrix/MatrixVersions.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"

#include "Diagnostics.h"

namespace Drydock
{

namespace
{

void WriteMessage(FJsonWriter& Writer, const FMatrixMessage& Message)
{
	Writer.BeginObject(true);
	if (Message.Code > 0)
	{
		Writer.Member("code", FormatCode(Message.Code));
	}
	else
	{
		Writer.Key("code").Null();
	}
	Writer.Member("file", Message.File);
	Writer.Member("line", Message.Line);
	Writer.Member("where", Message.Where);
	Writer.Member("text", Message.Text);
	Writer.EndObject();
}

void WriteFirstError(FJsonWriter& Writer, const std::optional<FMatrixMessage>& Error)
{
	Writer.Key("firstError");
	if (Error)
	{
		WriteMessage(Writer, *Error);
		return;
	}
	Writer.Null();
}

void WriteMessages(FJsonWriter& Writer, const char* Key, const std::vector<FMatrixMessage>& Messages)
{
	Writer.Key(Key).BeginArray();
	for (const FMatrixMessage& Message : Messages)
	{
		WriteMessage(Writer, Message);
	}
	Writer.EndArray();
}

void WriteTexts(FJsonWriter& Writer, const char* Key, const std::vector<std::string>& Texts)
{
	Writer.Key(Key).BeginArray();
	for (const std::string& Text : Texts)
	{
		Writer.Value(Text);
	}
	Writer.EndArray();
}

void WriteVersion(FJsonWriter& Writer, const char* Key, const std::optional<int>& Minor)
{
	Writer.Key(Key);
	Minor ? Writer.Value(DescribeVersion(*Minor)) : Writer.Null();
}

void WriteRun(FJsonWriter& Writer, const std::optional<FMatrixRun>& Run)
{
	Writer.Key("run");
	if (!Run)
	{
		Writer.Null();
		return;
	}
	Writer.BeginObject();
	Writer.Member("exitCode", Run->ExitCode);
	Writer.Key("end");
	Run->Ran() ? Writer.Null() : Writer.Value(DescribeEnd(*Run));
	WriteFirstError(Writer, Run->FirstError);
	WriteMessages(Writer, "warnings", Run->Warnings);
	WriteTexts(Writer, "extensions", Run->Extensions);
	Writer.Member("folder", Run->Folder);
	Writer.EndObject();
}

void WritePicture(FJsonWriter& Writer, const std::optional<FMatrixPicture>& Picture)
{
	Writer.Key("picture");
	if (!Picture)
	{
		Writer.Null();
		return;
	}
	Writer.BeginObject();
	Writer.Member("fingerprint", Picture->Fingerprint);
	WriteVersion(Writer, "before", Picture->Before);
	Writer.Key("same");
	Picture->Before ? Writer.Value(!Picture->Difference) : Writer.Null();
	if (Picture->Difference && !Picture->Difference->bOtherSize)
	{
		Writer.Member("max", Picture->Difference->Max);
		Writer.Member("pixels", Picture->Difference->NumPixels);
		Writer.Key("first").BeginArray(true);
		Writer.Value(Picture->Difference->X);
		Writer.Value(Picture->Difference->Y);
		Writer.EndArray();
	}
	WriteVersion(Writer, "sameAs", Picture->SameAs);
	Writer.EndObject();
}

void WriteRow(FJsonWriter& Writer, const FMatrixRow& Row)
{
	Writer.BeginObject();
	Writer.Member("engine", DescribeVersion(Row.Minor));
	Writer.Member("builds", Row.Build.bBuilt);
	WriteFirstError(Writer, Row.Build.FirstError);
	WriteMessages(Writer, "compilerWarnings", Row.Build.Warnings);
	WriteTexts(Writer, "notes", Row.Build.Notes);
	Writer.Member("library", Row.Build.Library);
	Writer.Member("log", Row.Build.Log);
	WriteRun(Writer, Row.Run);
	WritePicture(Writer, Row.Picture);
	Writer.Key("firstDifference");
	if (Row.FirstDifference)
	{
		Writer.BeginObject(true);
		Writer.Member("pass", Row.FirstDifference->Pass);
		Writer.Member("what", Row.FirstDifference->What);
		Writer.EndObject();
	}
	else
	{
		Writer.Null();
	}
	Writer.EndObject();
}

} // namespace

std::string MakeMatrixJson(const FVersionMatrix& Matrix)
{
	FJsonWriter Writer;
	Writer.BeginObject();
	Writer.Member("plugin", Matrix.Name);
	Writer.Member("folder", Matrix.Folder);
	Writer.Member("config", Matrix.Config);
	Writer.Key("versions").BeginArray();
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		WriteRow(Writer, Row);
	}
	Writer.EndArray();
	Writer.Member("summary", SummarizeMatrix(Matrix));
	WriteTexts(Writer, "advice", AdviseOnMatrix(Matrix));
	Writer.Member("passed", GetMatrixExitCode(Matrix) == ExitDone);
	Writer.EndObject();
	return Writer.GetText();
}

} // namespace Drydock
