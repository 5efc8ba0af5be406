// Writes a syntax tree as text, for the tests of the parser: every operator in parentheses, every node's kind in sight.
#pragma once

#include "HlslParser.h"

#include <string>

namespace Drydock::Hlsl::Test
{

class FTreePrinter
{
public:
	static std::string Print(const FTree& Tree)
	{
		std::string Text;
		for (const FDeclaration* Each : Tree.Declarations)
		{
			Text += (Text.empty() ? "" : " ") + Print(*Each);
		}
		return Text;
	}

	static std::string Print(const FDeclaration& Each)
	{
		std::string Text;
		for (const FAttribute& Attribute : Each.Attributes)
		{
			Text += Print(Attribute);
		}
		if (Each.bTemplate)
		{
			Text += "template<" + Join(Each.Template, [](const FTemplateParameter& P) { return Print(P); }) + "> ";
		}
		switch (Each.Kind)
		{
		case EDeclaration::Struct:
			return Text + PrintModifiers(Each.Modifiers) + "struct " + Print(Each.Name) + Print(*Each.Struct) + ";";
		case EDeclaration::Enum:
			return Text + Print(*Each.Enum) + ";";
		case EDeclaration::Namespace:
			return Text + "namespace " + Print(Each.Name) + PrintMembers(Each.Members);
		case EDeclaration::Buffer:
			return Text + (Each.bTBuffer ? "tbuffer " : "cbuffer ") + Print(Each.Name) + PrintAnnotations(Each) +
				   PrintMembers(Each.Members);
		case EDeclaration::Assert:
			return Text + "assert(" + Print(Each.Value) + (Each.Text.empty() ? "" : ", " + std::string(Each.Text)) +
				   ");";
		case EDeclaration::Using:
			return Text + "using " + (Each.Text.empty() ? "" : std::string(Each.Text) + " ") + Print(Each.Name) + ";";
		case EDeclaration::Pack:
			return "pack;";
		default:
			break;
		}
		Text += Each.Kind == EDeclaration::Typedef ? "typedef " : "";
		Text += PrintModifiers(Each.Modifiers & ~uint32_t(Each.Type->Modifiers)) + Print(*Each.Type) + " " +
				Print(Each.Name) + std::string(Each.Operator) + PrintDimensions(Each.Dimensions);
		if (Each.Kind == EDeclaration::Function)
		{
			Text += "(" + Join(Each.Parameters, [](const FDeclaration* P) { return Print(*P); }) + ")" +
					(Each.bConstMethod ? " const" : "");
		}
		Text += PrintAnnotations(Each);
		if (Each.Value != nullptr)
		{
			Text += (Each.bConstructed ? " " : " = ") + Print(Each.Value);
		}
		return Text + (Each.Body != nullptr ? " " + Print(Each.Body) : ";");
	}

	static std::string Print(const FStatement* Each)
	{
		if (Each == nullptr)
		{
			return "-";
		}
		std::string Text;
		for (const FAttribute& Attribute : Each->Attributes)
		{
			Text += Print(Attribute);
		}
		const auto Body = [&](size_t Index)
		{
			return Index < Each->Body.size() ? " " + Print(Each->Body[Index]) : "";
		};
		switch (Each->Kind)
		{
		case EStatement::Block:
			return Text + "{" +
				   Join(
					   Each->Body, [](const FStatement* S) { return Print(S); }, " ") +
				   "}";
		case EStatement::Declaration:
			return Text + Join(
							  Each->Declarations, [](const FDeclaration* D) { return Print(*D); }, " ");
		case EStatement::Expression:
			return Text + Print(Each->Value) + ";";
		case EStatement::If:
			return Text + "if (" + (Each->Condition != nullptr ? Print(*Each->Condition) : Print(Each->Value)) + ")" +
				   Body(0) + (Each->Body.size() > 1 ? " else" + Body(1) : "");
		case EStatement::For:
			return Text + "for (" + Print(Each->Body[0]) + " " + Print(Each->Value) + "; " + Print(Each->Step) + ")" +
				   Body(1);
		case EStatement::While:
			return Text + "while (" + Print(Each->Value) + ")" + Body(0);
		case EStatement::Do:
			return Text + "do" + Body(0) + " while (" + Print(Each->Value) + ");";
		case EStatement::Switch:
			return Text + "switch (" + Print(Each->Value) + ")" + Body(0);
		case EStatement::Case:
			return Text + "case " + Print(Each->Value) + ":";
		case EStatement::Default:
			return Text + "default:";
		case EStatement::Break:
			return Text + "break;";
		case EStatement::Continue:
			return Text + "continue;";
		case EStatement::Return:
			return Text + "return" + (Each->Value != nullptr ? " " + Print(Each->Value) : "") + ";";
		case EStatement::Discard:
			return Text + "discard;";
		case EStatement::Empty:
			return Text + ";";
		}
		return Text;
	}

	static std::string Print(const FExpression* Each)
	{
		if (Each == nullptr)
		{
			return "-";
		}
		const auto Operand = [&](size_t Index)
		{
			return Print(Each->Operands.at(Index));
		};
		const auto Arguments = [&](size_t First)
		{
			return Join(std::vector<FExpression*>(Each->Operands.begin() + ptrdiff_t(First), Each->Operands.end()),
				[](const FExpression* E) { return Print(E); });
		};
		const std::string Sign(Each->Text);
		switch (Each->Kind)
		{
		case EExpression::Name:
			return Print(Each->Name);
		case EExpression::Unary:
			return "(" + Sign + Operand(0) + ")";
		case EExpression::Postfix:
			return "(" + Operand(0) + Sign + ")";
		case EExpression::Binary:
		case EExpression::Assign:
		case EExpression::Comma:
			return "(" + Operand(0) + " " + Sign + " " + Operand(1) + ")";
		case EExpression::Conditional:
			return "(" + Operand(0) + " ? " + Operand(1) + " : " + Operand(2) + ")";
		case EExpression::Call:
			return Operand(0) + "(" + Arguments(1) + ")";
		case EExpression::Member:
			return Operand(0) + "." + Print(Each->Name);
		case EExpression::Index:
			return Operand(0) + "[" + Operand(1) + "]";
		case EExpression::Cast:
			return "cast<" + Print(*Each->Type) + ">(" + Operand(0) + ")";
		case EExpression::Construct:
			return "new " + Print(*Each->Type) + "(" + Arguments(0) + ")";
		case EExpression::List:
			return "{" + Arguments(0) + "}";
		case EExpression::SizeOf:
			return "sizeof(" + (Each->Type != nullptr ? "type " + Print(*Each->Type) : Operand(0)) + ")";
		default:
			return Sign;
		}
	}

	static std::string Print(const FTypeName& Type)
	{
		const std::string Modifiers = PrintModifiers(Type.Modifiers);
		if (Type.Enum != nullptr)
		{
			return Modifiers + Print(*Type.Enum);
		}
		if (Type.Struct != nullptr)
		{
			return Modifiers + "struct " + Print(Type.Name) + Print(*Type.Struct);
		}
		return Modifiers + Print(Type.Name) + PrintDimensions(Type.Dimensions);
	}

private:
	template<typename T, typename F>
	static std::string Join(const std::vector<T>& Each, const F& Print, const char* Between = ", ")
	{
		std::string Text;
		for (size_t Index = 0; Index < Each.size(); ++Index)
		{
			Text += (Index > 0 ? Between : "") + Print(Each[Index]);
		}
		return Text;
	}

	static std::string Print(const FName& Name)
	{
		return (Name.bGlobal ? "::" : "") +
			   Join(
				   Name.Parts,
				   [](const FNamePart& Part) {
					   return std::string(Part.Text) +
							  (Part.bArguments ? "<" + Join(Part.Arguments, PrintArgument) + ">" : "");
				   },
				   "::");
	}

	static std::string PrintArgument(const FTemplateArgument& Argument)
	{
		return Argument.Type != nullptr ? "type " + Print(*Argument.Type) : Print(Argument.Value);
	}

	static std::string Print(const FTemplateParameter& Parameter)
	{
		const bool bDefault = Parameter.Default.Type != nullptr || Parameter.Default.Value != nullptr;
		return (Parameter.ValueType != nullptr ? Print(*Parameter.ValueType) : "typename") + " " +
			   std::string(Parameter.Name) + (bDefault ? " = " + PrintArgument(Parameter.Default) : "");
	}

	static std::string Print(const FAttribute& Attribute)
	{
		return "[" + Attribute.Name +
			   (Attribute.Arguments.empty()
					   ? ""
					   : "(" + Join(Attribute.Arguments, [](const FExpression* E) { return Print(E); }) + ")") +
			   "] ";
	}

	static std::string Print(const FStruct& Struct)
	{
		return (Struct.bClass ? " class" : "") +
			   (Struct.Bases.empty() ? std::string()
									 : " : " + Join(Struct.Bases, [](const FTypeName* Base) { return Print(*Base); })) +
			   PrintMembers(Struct.Members);
	}

	static std::string Print(const FEnum& Enum)
	{
		return (Enum.bScoped ? "enum class " : "enum ") + std::string(Enum.Name) +
			   (Enum.Base != nullptr ? " : " + Print(*Enum.Base) : "") + " {" +
			   Join(Enum.Enumerators, [](const FEnumerator& Each)
				   { return std::string(Each.Name) + (Each.Value != nullptr ? " = " + Print(Each.Value) : ""); }) +
			   "}";
	}

	static std::string PrintMembers(const std::vector<FDeclaration*>& Members)
	{
		return " {" +
			   Join(
				   Members, [](const FDeclaration* D) { return Print(*D); }, " ") +
			   "}";
	}

	static std::string PrintDimensions(const std::vector<FExpression*>& Dimensions)
	{
		std::string Text;
		for (const FExpression* Each : Dimensions)
		{
			Text += "[" + (Each != nullptr ? Print(Each) : "") + "]";
		}
		return Text;
	}

	static std::string PrintAnnotations(const FDeclaration& Declaration)
	{
		std::string Text;
		for (const FAnnotation& Each : Declaration.Annotations)
		{
			Text += " : " + std::string(Each.Name);
			if (!Each.Arguments.empty())
			{
				Text +=
					"(" + Join(Each.Arguments, [](std::string_view Argument) { return std::string(Argument); }) + ")";
			}
		}
		return Text;
	}

	static std::string PrintModifiers(uint32_t Modifiers)
	{
		static const char* const Names[] = {"static", "const", "uniform", "extern", "groupshared", "precise", "in",
			"out", "row_major", "column_major", "inline", "volatile", "unorm", "snorm", "nointerpolation", "linear",
			"centroid", "noperspective", "sample", "globallycoherent", "export", "packed"};
		std::string Text;
		for (size_t Bit = 0; Bit < std::size(Names); ++Bit)
		{
			Text += (Modifiers >> Bit & 1) != 0 ? std::string(Names[Bit]) + " " : "";
		}
		return Text;
	}
};

} // namespace Drydock::Hlsl::Test
