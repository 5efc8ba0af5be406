// Writes a shader's file scope and its functions. Arithmetic is left to the interpreter, so that the bits are the
// interpreter's; the author's variables, branches and calls are those of C++.
#include "DebugEmitter.h"

#include "DebugEmitterImpl.h"
#include "ShaderDirectories.h"
#include "SpirvPlace.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

using namespace Spirv;

FDebugEmitter::FDebugEmitter(const FInspectedShader& Shader, std::string InEntry)
	: Module(Shader.GetModule())
	, Program(Shader.GetProgram())
	, Types(Module)
	, Entry(std::move(InEntry))
	, Functions(Module.Functions)
{
	if (Functions.empty()) // all was inlined into one
	{
		FSpirvFunction& Whole = Functions.emplace_back();
		Whole.Id = Module.EntryFunction;
		Whole.Name = Entry;
		Whole.NumBlocks = uint32_t(Module.Blocks.size());
	}
}

std::string FDebugEmitter::Emit()
{
	FindConstants();
	FindGlobals();
	for (const FSpirvFunction& Function : Functions)
	{
		Declare(Function);
	}
	for (const FSpirvFunction& Function : Functions)
	{
		Define(Function);
	}
	return "#include \"DebugKernelSupport.h\"\n" + Types.GetDefinitions() + Globals + Declarations +
		   "static uint64_t DrydockIncoming[" + std::to_string(NumIncoming) + "];\n" + Definitions + MakeKernel();
}

void FDebugEmitter::AddConstant(uint32_t Variable, uint32_t Member)
{
	const FSpirvMember& Of = Module.GetType(Module.Variables[Variable].Type).Members.at(Member);
	const auto [Found, bNew] = Constants.try_emplace({Variable, Member});
	if (!bNew || !Types.IsNumeric(Of.Type))
	{
		return;
	}
	Found->second = "::" + Types.TakeName(Of.Name);
	Globals += "static " + Types.NameOf(Of.Type) + " " + Found->second.substr(2) + ";\n";
	const std::vector<uint32_t> Offsets = GetScalarOffsets(Module, Of.Type, Of.MatrixStride, Of.bRowMajor);
	std::string OffsetList;
	std::string KindList;
	for (size_t i = 0; i < Offsets.size(); ++i)
	{
		OffsetList += std::to_string(Of.Offset + Offsets[i]) + ", ";
		KindList += std::to_string(int(Module.GetScalarKind(Of.Type, uint32_t(i)))) + ", ";
	}
	const std::string Count = std::to_string(Offsets.size());
	ConstantReads += "\t{\n\t\tstatic const uint Offsets[] = {" + OffsetList +
					 "};\n\t\tstatic const unsigned char Kinds[] = {" + KindList + "};\n\t\tuint64_t Read[" + Count +
					 "];\n\t\tfor (uint i = 0; i < " + Count +
					 "; ++i)\n\t\t\tRead[i] = DrydockRun->ReadConstant(DrydockRun->Self, " + std::to_string(Variable) +
					 ", Offsets[i], Kinds[i]);\n\t\t" + Types.CopyFromWords(Of.Type, Found->second, "Read") + "\n\t}\n";
}

/** Constants that the shader reads, each a variable by its own name. */
void FDebugEmitter::FindConstants()
{
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (I.Op != OpAccessChain && I.Op != OpInBoundsAccessChain)
			{
				continue;
			}
			Chains[I.Result] = &I;
			const auto Variable = Module.VariableIndex.find(I.Operands[0]);
			if (Variable == Module.VariableIndex.end() || I.Operands.size() < 2)
			{
				continue;
			}
			const FSpirvVariable& Base = Module.Variables[Variable->second];
			const FSpirvType& Type = Module.GetType(Base.Type);
			if (Base.Storage == StorageUniform && Type.Kind == ESpirvType::Struct && !Type.bBufferBlock)
			{
				AddConstant(Variable->second, Module.GetConstantScalar(I.Operands[1]));
			}
		}
	}
}

/** The author's static variables. */
void FDebugEmitter::FindGlobals()
{
	for (size_t i = 0; i < Module.Variables.size(); ++i)
	{
		const FSpirvVariable& Variable = Module.Variables[i];
		if (Variable.Storage == StoragePrivate && Types.IsNumeric(Variable.Type) && !IsHiddenVariable(Program, i))
		{
			const std::string Name = Types.TakeName(Variable.Name);
			Globals += "static " + Types.NameOf(Variable.Type) + " " + Name + ";\n";
			ConstantReads += "\t" + Types.CopyFromWords(Variable.Type, "::" + Name, At(Program.Memory[i].First)) + "\n";
			Roots[Variable.Id] = {"::" + Name, Variable.Type};
		}
	}
}

bool FDebugEmitter::IsShownPointer(uint32_t TypeId) const
{
	const FSpirvType& Type = Module.GetType(TypeId);
	return Type.Kind == ESpirvType::Pointer && Type.Storage == StorageFunction && Types.IsNumeric(Type.Element);
}

uint32_t FDebugEmitter::GetReturnType(const FSpirvFunction& Function) const
{
	return Function.Type && Module.GetType(Function.Type).Kind != ESpirvType::Void ? Function.Type : 0;
}

std::string FDebugEmitter::MakeReturnType(const FSpirvFunction& Function)
{
	const uint32_t Type = GetReturnType(Function);
	if (Type && !Types.IsNumeric(Type))
	{
		Module.Fail("the function '" + Function.Name + "' returns a texture or a buffer");
	}
	return !Type ? "void" : Types.IsArray(Type) ? "DrydockValue<" + Types.NameOf(Type) + ">" : Types.NameOf(Type);
}

void FDebugEmitter::Declare(const FSpirvFunction& Function)
{
	FNamed& Known = Named[Function.Id];
	if (Function.Name.empty())
	{
		Known.Name = "DrydockEntry";
		Known.Signature = "static void DrydockEntry()";
		Declarations += Known.Signature + ";\n";
		return;
	}
	std::string Parameters;
	std::string ParameterTypes;
	for (const uint32_t Parameter : Function.Parameters)
	{
		const uint32_t TypeId = Module.GetValueTypeId(Parameter);
		const uint32_t Type = IsShownPointer(TypeId) ? Module.GetType(TypeId).Element : TypeId;
		const auto Name = Module.Names.find(Parameter);
		if (!Types.IsNumeric(Type) || Types.IsArray(Type) || Name == Module.Names.end())
		{
			continue; // textures are the interpreter's alone; arrays become local variables
		}
		Parameters += (Parameters.empty() ? "" : ", ") + Types.NameOf(Type) + " " + MakeCppName(Name->second);
		ParameterTypes += Types.NameOf(Type) + ",";
	}
	auto& Name = FunctionNames[Function.Name];
	if (Name.empty() || !Signatures.insert(Name + "(" + ParameterTypes).second)
	{
		Name = Types.TakeName(Function.Name);
		Signatures.insert(Name + "(" + ParameterTypes);
	}
	Known.Name = Name;
	const std::string Type = MakeReturnType(Function);
	Known.Signature = "static " + Type + " " + Name + "(" + Parameters + ")";
	Declarations += Known.Signature + ";\n";
	if (GetReturnType(Function))
	{
		Known.Result = "DrydockResult" + std::to_string(Function.Id);
		Declarations += "static " + Type + " " + Known.Result + ";\n";
	}
}

void FDebugEmitter::SetLine(uint32_t File, int Line)
{
	if (Line > 0)
	{
		std::string& Path = Files[File];
		if (Path.empty())
		{
			std::error_code Error;
			const std::string OnDisk = FindShaderFile(Module.Files.at(File));
			const std::filesystem::path Real = std::filesystem::canonical(OnDisk, Error);
			Path = OnDisk.empty() || Error ? Module.Files.at(File) : Real.string();
		}
		LastFile = Path;
		LastLine = Line;
	}
	if (LastLine > 0)
	{
		Definitions += "#line " + std::to_string(LastLine) + " " + QuoteForCpp(LastFile) + "\n";
	}
}

/** Name, parameters, and variables that live as long as the function runs. */
void FDebugEmitter::OpenFunction(const FSpirvFunction& Function, const std::vector<FDebugLocal>& Locals)
{
	for (uint32_t Block = Function.FirstBlock; Block < Function.FirstBlock + Function.NumBlocks; ++Block)
	{
		const std::vector<FSpirvInstruction>& Instructions = Module.Blocks[Block].Instructions;
		const auto First = std::ranges::find_if(Instructions, [](const FSpirvInstruction& I) { return I.Line > 0; });
		if (First != Instructions.end())
		{
			SetLine(First->File, First->Line);
			break;
		}
	}
	Definitions += Named[Function.Id].Signature + " { ";
	for (const uint32_t Parameter : Function.Parameters)
	{
		const uint32_t TypeId = Module.GetValueTypeId(Parameter);
		const bool bPointer = IsShownPointer(TypeId);
		const uint32_t Type = bPointer ? Module.GetType(TypeId).Element : TypeId;
		const auto Name = Module.Names.find(Parameter);
		if (!Types.IsNumeric(Type) || Name == Module.Names.end())
		{
			continue;
		}
		const std::string CppName = MakeCppName(Name->second);
		if (Types.IsArray(Type))
		{
			const uint32_t Words = Program.WordOf(Parameter);
			Definitions += Types.NameOf(Type) + " " + CppName + "; " +
						   Types.CopyFromWords(Type, CppName, bPointer ? AtPointer(Words) : At(Words));
		}
		if (bPointer)
		{
			Roots[Parameter] = {CppName, Type};
		}
	}
	for (const FDebugLocal& Local : Locals)
	{
		const FSpirvVariable& Variable = Module.Variables[Local.Variable];
		Roots[Variable.Id] = {Local.Name, Variable.Type};
		if (!Local.bScoped)
		{
			Definitions += Types.NameOf(Variable.Type) + " " + Local.Name + " = {}; ";
			Definitions += Variable.Initializer ? Types.CopyFromWords(Variable.Type, Local.Name,
													  At(Program.WordOf(Variable.Initializer)))
												: std::string();
		}
	}
	Definitions += "\n";
}

/** Static, because a goto may lead into the braces; cleared before each run. */
std::string FDebugEmitter::OpenScopes(std::vector<FDebugLocal> Locals, size_t Position)
{
	std::ranges::sort(Locals, std::greater(), &FDebugLocal::Last);
	std::string Text;
	for (const FDebugLocal& Local : Locals)
	{
		if (Local.bScoped && Local.First == Position)
		{
			Text += "{ static " + Types.NameOf(Module.Variables[Local.Variable].Type) + " " + Local.Name +
					" __attribute__((section(\"drydock_locals\"))); ";
		}
	}
	return Text;
}

void FDebugEmitter::Define(const FSpirvFunction& Function)
{
	std::set<std::string> Parameters;
	for (const uint32_t Parameter : Function.Parameters)
	{
		const auto Name = Module.Names.find(Parameter);
		Parameters.insert(Name == Module.Names.end() ? std::string() : MakeCppName(Name->second));
	}
	const std::vector<FDebugLocal> Locals =
		Function.Name.empty() ? std::vector<FDebugLocal>() : FindDebugLocals(Program, Function, Parameters);
	OpenFunction(Function, Locals);
	size_t Position = 0;
	for (uint32_t Index = Function.FirstBlock; Index < Function.FirstBlock + Function.NumBlocks; ++Index)
	{
		const FSpirvBlock& Block = Module.Blocks[Index];
		uint32_t Step = Program.Blocks[Index].FirstStep;
		Definitions += "Block" + std::to_string(Block.Label) + ":;\n";
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			Definitions += OpenScopes(Locals, Position) + "\n";
			if (I.Op != OpPhi)
			{
				SetLine(I.File, I.Line);
				Definitions += MakeStatement(Function, Block, Step) + "\n";
				++Step;
			}
			for (const FDebugLocal& Local : Locals)
			{
				Definitions += Local.bScoped && Local.Last == Position ? "}\n" : "";
			}
			++Position;
		}
	}
	Definitions += "}\n";
}

std::string FDebugEmitter::MakeKernel() const
{
	const auto Found = Named.find(Module.EntryFunction);
	if (Found == Named.end())
	{
		Module.Fail("SPIR-V: the module has no entry function");
	}
	return "#line 1 \"drydock\"\nstatic uint DrydockFirstLocal __attribute__((section(\"drydock_locals\")));\n"
		   "extern \"C\" __attribute__((visibility(\"hidden\"))) unsigned char __start_drydock_locals[], "
		   "__stop_drydock_locals[];\n"
		   "extern \"C\" __attribute__((visibility(\"default\"))) void DrydockDebugKernel("
		   "Drydock::FDebugKernelArgs& Run)\n{\n\tDrydockRun = &Run;\n\tDrydockWords = Run.Words;\n"
		   "\tDrydockPixel = {Run.Position[0], Run.Position[1], Run.Position[2]};\n\tDrydockSetPixel Set;\n"
		   "\tDrydockFirstLocal = 0;\n"
		   "\t__builtin_memset(__start_drydock_locals, 0, __stop_drydock_locals - __start_drydock_locals);\n" +
		   ConstantReads + "\t" + Found->second.Name + "();\n}\n";
}

std::string EmitDebugKernel(const FInspectedShader& Shader, const std::string& Entry)
{
	return FDebugEmitter(Shader, Entry).Emit();
}

} // namespace Drydock
