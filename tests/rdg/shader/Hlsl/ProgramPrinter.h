// A program of the HLSL front end as text, for tests.
#pragma once

#include "HlslAnalysis.h"
#include "HlslParser.h"

#include <cstring>
#include <string>

namespace Drydock::Hlsl
{

class FProgramPrinter
{
public:
	explicit FProgramPrinter(const FProgram& InProgram)
		: Program(InProgram)
	{
	}

	std::string Print()
	{
		std::string Text;
		for (const FBuffer* Buffer : Program.Buffers)
		{
			Text += (Buffer->bTBuffer ? "tbuffer " : "cbuffer ") + Buffer->Name + " {";
			for (size_t i = 0; i < Buffer->Members.size(); ++i)
			{
				Text += " " + GetName(Buffer->Members[i]->Type) + " " + Buffer->Members[i]->Name + " @" +
						std::to_string(Buffer->Offsets[i]) + ";";
			}
			Text += " }\n";
		}
		for (const FVariable* Variable : Program.Resources)
		{
			Text += "resource " + Declare(*Variable) + "\n";
		}
		for (const FVariable* Variable : Program.Statics)
		{
			Text += (Variable->Storage == EStorage::Groupshared ? "groupshared " : "static ") + Declare(*Variable);
			Text += Variable->Constant      ? " = " + PrintConstant(Variable->Type, *Variable->Constant)
					: Variable->Initializer ? " = " + PrintValue(*Variable->Initializer)
											: "";
			Text += "\n";
		}
		for (const FFunction* Function : Program.Functions)
		{
			Text += PrintFunction(*Function);
		}
		return Text;
	}

	std::string PrintFunction(const FFunction& Function)
	{
		std::string Text = GetName(Function.Result) + " " + Function.Name + "(";
		for (const FVariable* Parameter : Function.Parameters)
		{
			const bool bOut = (Parameter->Modifiers & ModifierOut) != 0;
			const bool bIn = (Parameter->Modifiers & ModifierIn) != 0;
			Text += std::string(Text.back() == '(' ? "" : ", ") + (bOut ? (bIn ? "inout " : "out ") : "") +
					Declare(*Parameter) + (Parameter->Semantic.empty() ? "" : " : " + Parameter->Semantic);
		}
		Text += ")" + (Function.Semantic.empty() ? "" : " : " + Function.Semantic) + "\n";
		return Text + PrintCode(*Function.Body, 0);
	}

	static std::string Declare(const FVariable& Variable) { return GetName(Variable.Type) + " " + Variable.Name; }

	std::string PrintCode(const FCode& Code, int Indent)
	{
		const std::string Tabs(size_t(Indent), '\t');
		const std::string Value = Code.Value ? PrintValue(*Code.Value) : "";
		std::string Text = Tabs;
		switch (Code.Kind)
		{
		case EStep::Block:
			Text += "{\n";
			for (const FCode* Each : Code.Body)
			{
				Text += PrintCode(*Each, Indent + 1);
			}
			return Text + Tabs + "}\n";
		case EStep::Variable:
			return Text + Declare(*Code.Variable) + (Value.empty() ? "" : " = " + Value) + "\n";
		case EStep::Value:
			return Text + Value + "\n";
		case EStep::If:
			Text += "if " + Value + "\n" + PrintCode(*Code.Body[0], Indent);
			return Code.Body.size() > 1 ? Text + Tabs + "else\n" + PrintCode(*Code.Body[1], Indent) : Text;
		case EStep::Loop:
		case EStep::DoLoop:
			Text += std::string(Code.Kind == EStep::Loop ? "loop " : "do ") + Value;
			Text += Code.Next ? " next " + PrintValue(*Code.Next) : "";
			Text += Code.bUnroll ? " unroll " + std::to_string(Code.MaxTurns) : "";
			Text += Code.bLoop ? " loop" : "";
			Text += "\n" + (Code.Body[0] && !Code.Body[0]->Body.empty() ? PrintCode(*Code.Body[0], Indent) : "");
			return Text + PrintCode(*Code.Body[1], Indent);
		case EStep::Switch:
			Text += "switch " + Value + "\n";
			for (const FCase& Case : Code.Cases)
			{
				Text += Tabs + "case";
				for (const uint32_t Label : Case.Labels)
				{
					Text += " " + std::to_string(int32_t(Label));
				}
				Text += Case.bDefault ? " default:\n" : ":\n";
				for (const FCode* Each : Case.Body)
				{
					Text += PrintCode(*Each, Indent + 1);
				}
			}
			return Text;
		case EStep::Break:
			return Text + "break\n";
		case EStep::Continue:
			return Text + "continue\n";
		case EStep::Return:
			return Text + "return" + (Value.empty() ? "" : " " + Value) + "\n";
		case EStep::Discard:
			return Text + "discard\n";
		}
		return Text;
	}

	static std::string PrintScalar(EScalar Scalar, uint64_t Bits)
	{
		char Buffer[64];
		double Number = 0;
		float Single = 0;
		const uint32_t Low = uint32_t(Bits);
		switch (Scalar)
		{
		case EScalar::Bool:
			return Bits ? "true" : "false";
		case EScalar::Double:
		case EScalar::LiteralFloat:
			std::memcpy(&Number, &Bits, sizeof(Number));
			break;
		case EScalar::Float:
		case EScalar::MinFloat:
		case EScalar::Half:
			std::memcpy(&Single, &Low, sizeof(Single));
			Number = double(Single);
			break;
		case EScalar::Long:
		case EScalar::LiteralInt:
			return std::to_string(int64_t(Bits));
		case EScalar::Ulong:
			return std::to_string(Bits);
		default:
			return IsUnsigned(Scalar) ? std::to_string(Low) + "u" : std::to_string(int32_t(Low));
		}
		std::snprintf(Buffer, sizeof(Buffer), "%.7g", Number);
		const std::string Text = Buffer;
		return Text.find_first_of(".einf") == std::string::npos ? Text + ".0" : Text;
	}

	static std::string PrintConstant(const FType* Type, const FConstant& Constant)
	{
		std::string Text;
		for (size_t i = 0; i < Constant.size(); ++i)
		{
			Text += (i ? ", " : "") + PrintScalar(GetScalarAt(Type, uint32_t(i)), Constant[i]);
		}
		return Type->IsScalar() ? Text : GetName(Type) + "(" + Text + ")";
	}

	std::string PrintAll(const std::vector<FValue*>& Values, size_t First = 0)
	{
		std::string Text;
		for (size_t i = First; i < Values.size(); ++i)
		{
			Text += (i > First ? ", " : "") + PrintValue(*Values[i]);
		}
		return Text;
	}

	std::string PrintValue(const FValue& Value)
	{
		const auto Operand = [&](size_t i)
		{
			return PrintValue(*Value.Operands[i]);
		};
		const std::string Operator(Value.Operator);
		switch (Value.Kind)
		{
		case EValue::Constant:
			return PrintConstant(Value.Type, Value.Constant);
		case EValue::Variable:
			return Value.Variable->Name;
		case EValue::Member:
		{
			const FType* const Of = Value.Operands[0]->Type;
			const FType* const Struct = Of->IsObject() ? Of->Element : Of;
			return Operand(0) + "." + Struct->Struct->Members[Value.Index].Name +
				   (CountName(*Struct->Struct, Struct->Struct->Members[Value.Index].Name) > 1
						   ? "#" + std::to_string(Value.Index)
						   : "");
		}
		case EValue::Index:
			return Operand(0) + "[" + Operand(1) + "]";
		case EValue::Element:
			return Operand(0) + "{" + Operand(1) + "}";
		case EValue::Swizzle:
		{
			std::string Parts;
			for (const uint8_t Part : Value.Parts)
			{
				Parts += "xyzw"[Part];
			}
			return Operand(0) + "." + Parts;
		}
		case EValue::Elements:
		{
			std::string Parts;
			for (const uint8_t Part : Value.Parts)
			{
				Parts += "_m" + std::to_string(Part / 4) + std::to_string(Part % 4);
			}
			return Operand(0) + "." + Parts;
		}
		case EValue::Bits:
			return Operand(0) + "{" + std::to_string(Value.Bits.First) + ":" + std::to_string(Value.Bits.Count) + "}";
		case EValue::Unary:
			return Operator + Operand(0);
		case EValue::Binary:
			return "(" + Operand(0) + " " + Operator + " " + Operand(1) + ")";
		case EValue::And:
			return "(" + Operand(0) + " && " + Operand(1) + ")";
		case EValue::Or:
			return "(" + Operand(0) + " || " + Operand(1) + ")";
		case EValue::Choose:
			return "(" + Operand(0) + " ? " + Operand(1) + " : " + Operand(2) + ")";
		case EValue::Select:
			return "select(" + PrintAll(Value.Operands) + ")";
		case EValue::Assign:
			return "(" + Operand(0) + " = " + Operand(1) + ")";
		case EValue::Modify:
			return "(" + Operand(0) + " " + Operator + "= " + Operand(1) + ")";
		case EValue::Step:
			return Value.bPostfix ? Operand(0) + Operator : Operator + Operand(0);
		case EValue::Convert:
			return GetName(Value.Type) + "(" + Operand(0) + ")";
		case EValue::Compose:
			return GetName(Value.Type) + "{" + PrintAll(Value.Operands) + "}";
		case EValue::Zero:
			return GetName(Value.Type) + "{0}";
		case EValue::Call:
			return Value.Function->Name + "(" + PrintAll(Value.Operands) + ")";
		case EValue::Intrinsic:
			return std::string(Value.Name) + "(" + PrintAll(Value.Operands) + ")";
		case EValue::Method:
			return Operand(0) + "." + std::string(Value.Name) + "(" + PrintAll(Value.Operands, 1) + ")";
		case EValue::Comma:
			return "(" + Operand(0) + ", " + Operand(1) + ")";
		case EValue::Cast:
			return "(" + GetName(Value.Type) + ")" + Operand(0);
		case EValue::String:
			return Value.Text;
		}
		return "?";
	}

private:
	static size_t CountName(const FStructType& Struct, const std::string& Name)
	{
		size_t Count = 0;
		for (const FMember& Member : Struct.Members)
		{
			Count += Member.Name == Name ? 1 : 0;
		}
		return Count;
	}

	const FProgram& Program;
};

} // namespace Drydock::Hlsl
